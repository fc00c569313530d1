// SPDX-License-Identifier: GPL-3.0-or-later
uniform mat4 uView;
uniform mat4 uProjection;
layout(location = 0) in vec3 aPosition;

void main()
{
    gl_Position = uProjection * (uView * vec4(aPosition, 1.0));
    gl_Position.z -= 4e-5 * gl_Position.w; // before the triangles whose edges these are
}
