// SPDX-License-Identifier: GPL-3.0-or-later
uniform mat4 uView;
uniform mat4 uProjection;
layout(location = 0) in vec2 aPlace; // x and z
layout(location = 1) in float aHeight;
layout(location = 2) in vec2 aNormal; // x and z; y is what is missing to 1
layout(location = 3) in vec4 aColor;  // sRGB, humidity
layout(location = 4) in float aNumber;
layout(location = 5) in vec2 aSlide; // x and z; see GroundSlide

#ifdef EDGES
#define OUT(name) g##name
#else
#define OUT(name) v##name
#endif
out vec3 OUT(Place); // in the scene
out vec3 OUT(Normal);
out vec4 OUT(Color);
out float OUT(Number);
out vec2 OUT(Slide);

void main()
{
    vec3 position = vec3(aPlace.x, aHeight, aPlace.y);
    OUT(Place) = position;
    OUT(Normal) = vec3(aNormal.x, sqrt(max(1.0 - dot(aNormal, aNormal), 0.0)), aNormal.y);
    OUT(Color) = aColor;
    OUT(Number) = aNumber;
    OUT(Slide) = aSlide / 256.0; // SlideSteps
    gl_Position = uProjection * (uView * vec4(position, 1.0));
}
