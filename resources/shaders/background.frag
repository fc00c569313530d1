// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 uTop; // linear
uniform vec3 uBottom;
uniform float uAspect;
in vec2 vPlace;
out vec4 oColor;

void main()
{
    vec3 color = mix(uBottom, uTop, smoothstep(0.0, 1.0, vPlace.y));
    // A soft light behind the object.
    vec2 fromMiddle = (vPlace - vec2(0.5, 0.55)) * vec2(uAspect, 1.0);
    color *= 1.0 + 0.35 * exp(-2.5 * dot(fromMiddle, fromMiddle));
    oColor = encoded(color);
}
