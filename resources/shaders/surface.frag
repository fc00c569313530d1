// SPDX-License-Identifier: GPL-3.0-or-later
uniform mat4 uView;
uniform vec3 uSurface;  // linear
uniform vec3 uBackSide; // linear
in vec3 vNormal;
in vec3 vPosition;
in float vError;
out vec4 oColor;

#ifdef EDGES
uniform vec4 uEdge;           // linear, alpha
uniform float uEdgeHalfWidth; // pixels
in vec3 vCorner;

// How much of this pixel an edge covers; edges of triangles smaller than a few pixels fade, or they would fill the
// picture.
float edgeCoverage()
{
    vec3 slope = sqrt(dFdx(vCorner) * dFdx(vCorner) + dFdy(vCorner) * dFdy(vCorner));
    vec3 pixels = vCorner / max(slope, vec3(1e-9));
    vec3 heights = 1.0 / max(slope, vec3(1e-9));
    float nearest = min(pixels.x, min(pixels.y, pixels.z));
    float smallest = min(heights.x, min(heights.y, heights.z));
    float coverage = 1.0 - smoothstep(uEdgeHalfWidth - 0.5, uEdgeHalfWidth + 0.5, nearest);
    return coverage * clamp(smallest / (uEdgeHalfWidth * 9.0), 0.12, 1.0);
}
#endif

void main()
{
#ifdef WIRE
    float coverage = edgeCoverage() * uEdge.a * (gl_FrontFacing ? 1.0 : 0.4);
    oColor = vec4(encoded(uErrorRange > 0.0 ? errorColor(vError) : uEdge.rgb).rgb, coverage);
#else
    vec3 toViewer = normalize(-vPosition);
    vec3 normal = normalize(vNormal);
    if (!gl_FrontFacing)
        normal = -normal;
    vec3 surface = gl_FrontFacing ? uSurface : uBackSide;
    if (uErrorRange > 0.0)
        surface = errorColor(vError);
    vec3 color = lit(surface, normal, toViewer, mat3(uView) * vec3(0.0, 1.0, 0.0));
#ifdef EDGES
    color = mix(color, uEdge.rgb, edgeCoverage() * uEdge.a);
#endif
    oColor = encoded(color);
#endif
}
