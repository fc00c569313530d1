// SPDX-License-Identifier: GPL-3.0-or-later
// Tells each fragment how far it is from the edges of its triangle.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
in vec3 gPlace[];
in vec3 gNormal[];
in vec4 gColor[];
in float gNumber[];
in vec2 gSlide[];
out vec3 vPlace;
out vec3 vNormal;
out vec4 vColor;
out float vNumber;
out vec2 vSlide;
out vec3 vCorner;

void main()
{
    for (int i = 0; i < 3; ++i) {
        vPlace = gPlace[i];
        vNormal = gNormal[i];
        vColor = gColor[i];
        vNumber = gNumber[i];
        vSlide = gSlide[i];
        vCorner = vec3(i == 0, i == 1, i == 2);
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
