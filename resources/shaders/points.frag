// SPDX-License-Identifier: GPL-3.0-or-later
uniform mat4 uView;
uniform vec3 uSurface;  // linear
uniform vec3 uBackSide; // linear
in vec3 vNormal;
in vec3 vPosition;
in float vError;
out vec4 oColor;

void main()
{
    vec2 fromMiddle = gl_PointCoord * 2.0 - 1.0;
    if (dot(fromMiddle, fromMiddle) > 1.0)
        discard;
    vec3 toViewer = normalize(-vPosition);
    vec3 normal = normalize(vNormal);
    bool isFront = dot(normal, toViewer) >= 0.0;
    vec3 surface = isFront ? uSurface : uBackSide;
    if (uErrorRange > 0.0)
        surface = errorColor(vError);
    vec3 color = lit(surface, isFront ? normal : -normal, toViewer,
                     mat3(uView) * vec3(0.0, 1.0, 0.0));
    oColor = encoded(isFront ? color : color * 0.45);
}
