// SPDX-License-Identifier: GPL-3.0-or-later
// The terrain from straight above, filling the picture: texture coordinates are place.xz / uHalf / 2 + 1 / 2.
uniform vec2 uHalf; // metres
layout(location = 0) in vec2 aPlace; // x and z
layout(location = 1) in float aHeight;
layout(location = 3) in vec4 aColor; // sRGB, humidity
layout(location = 4) in float aNumber;
out float vHeight;
out vec4 vColor;
out float vNumber;

void main()
{
    vHeight = aHeight;
    vColor = aColor;
    vNumber = aNumber;
    gl_Position = vec4(aPlace / uHalf, 0.0, 1.0);
}
