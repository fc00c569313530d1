// SPDX-License-Identifier: GPL-3.0-or-later
// A square on the floor; no vertex data.
uniform mat4 uView;
uniform mat4 uProjection;
uniform vec3 uMiddle;
uniform float uReach; // half a side
out vec2 vPlace;      // from the middle, in halves of a side
out vec2 vWorld;

void main()
{
    vPlace = vec2((gl_VertexID & 1) * 2.0 - 1.0, (gl_VertexID >> 1) * 2.0 - 1.0);
    vWorld = uMiddle.xz + vPlace * uReach;
    gl_Position = uProjection * uView * vec4(vWorld.x, uMiddle.y, vWorld.y, 1.0);
}
