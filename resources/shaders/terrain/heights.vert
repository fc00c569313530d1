// SPDX-License-Identifier: GPL-3.0-or-later
// The terrain from straight above, filling the picture: texture coordinates are place.xz / uHalf / 2 + 1 / 2.
uniform vec2 uHalf; // metres
layout(location = 0) in vec3 aPosition;
out float vHeight;

void main()
{
    vHeight = aPosition.y;
    gl_Position = vec4(aPosition.xz / uHalf, 0.0, 1.0);
}
