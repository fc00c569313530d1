// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of any width: a core profile need not have them.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
uniform vec2 uSize;       // pixels of the picture
uniform float uHalfWidth; // pixels
uniform int uFirstLine; // of this call
uniform usamplerBuffer uLineColors; // 0xAABBGGRR of each line
out vec3 vColor;
out float vAcross; // pixels from the middle of the line

void main()
{
    vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
    if (a.w <= 0.0 || b.w <= 0.0)
        return;
    vec2 along = (b.xy / b.w - a.xy / a.w) * uSize;
    float size = length(along);
    vec2 across = size > 1e-6 ? vec2(-along.y, along.x) / size : vec2(1.0, 0.0);
    uint color = texelFetch(uLineColors, uFirstLine + gl_PrimitiveIDIn).r;
    vec3 rgb = vec3(float(color & 255u), float((color >> 8) & 255u), float((color >> 16) & 255u)) / 255.0;
    float reach = uHalfWidth + 1.0;
    for (int i = 0; i < 4; ++i) {
        vec4 end = i < 2 ? a : b;
        float side = (i & 1) == 0 ? -1.0 : 1.0;
        vColor = rgb;
        vAcross = side * reach;
        gl_Position = end + vec4(across * side * reach * 2.0 / uSize * end.w, 0.0, 0.0);
        EmitVertex();
    }
    EndPrimitive();
}
