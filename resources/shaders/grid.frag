// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec4 uLine;  // linear, alpha
uniform float uCell; // world units
uniform float uLineHalfWidth; // pixels
in vec2 vPlace;
in vec2 vWorld;
out vec4 oColor;

float lines(float cell)
{
    vec2 cells = vWorld / cell;
    vec2 slope = max(fwidth(cells), vec2(1e-9));
    vec2 pixels = abs(fract(cells - 0.5) - 0.5) / slope;
    vec2 coverage = 1.0 - smoothstep(vec2(uLineHalfWidth - 0.5), vec2(uLineHalfWidth + 0.5), pixels);
    coverage *= 1.0 - smoothstep(vec2(0.15), vec2(0.5), slope); // too dense far away
    return max(coverage.x, coverage.y);
}

void main()
{
    float fade = 1.0 - smoothstep(0.25, 1.0, length(vPlace));
    float coverage = max(lines(uCell) * 0.45, lines(uCell * 5.0));
    oColor = vec4(toSrgb(uLine.rgb), uLine.a * coverage * fade);
}
