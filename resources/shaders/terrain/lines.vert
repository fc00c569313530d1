// SPDX-License-Identifier: GPL-3.0-or-later
uniform mat4 uView;
uniform mat4 uProjection;
layout(location = 0) in vec2 aPlace; // x and z
layout(location = 1) in float aHeight;

void main()
{
    gl_Position = uProjection * (uView * vec4(aPlace.x, aHeight, aPlace.y, 1.0));
    gl_Position.z -= 4e-5 * gl_Position.w; // before the triangles whose edges these are
}
