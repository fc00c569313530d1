// SPDX-License-Identifier: GPL-3.0-or-later
uniform mat4 uView;
uniform mat4 uProjection;
uniform float uPointSize; // pixels
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in float aError;
out vec3 vNormal;
out vec3 vPosition;
out float vError;

void main()
{
    vec4 place = uView * vec4(aPosition, 1.0);
    vPosition = place.xyz;
    vError = aError;
    vNormal = mat3(uView) * aNormal;
    gl_Position = uProjection * place;
    gl_PointSize = uPointSize;
}
