// SPDX-License-Identifier: GPL-3.0-or-later
uniform float uHalfWidth;
in vec3 vColor;
in float vAcross;
out vec4 oColor;

void main()
{
    oColor = vec4(vColor, 1.0 - smoothstep(uHalfWidth - 0.5, uHalfWidth + 0.5, abs(vAcross)));
}
