// SPDX-License-Identifier: GPL-3.0-or-later
// One triangle that covers the picture; no vertex data.
out vec2 vPlace; // 0..1 inside the picture, y up

void main()
{
    vPlace = vec2((gl_VertexID & 1) * 2.0, (gl_VertexID >> 1) * 2.0);
    gl_Position = vec4(vPlace * 2.0 - 1.0, 0.0, 1.0);
}
