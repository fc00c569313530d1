// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the sun and of the sky each place of the ground sees, from the horizons around it.
// Source: N. Max, Horizon Mapping: Shadows for Bump-Mapped Surfaces, 1988. Differs: horizons are searched when the
// ground changes, not stored.
uniform sampler2D uHeights;
uniform vec2 uHalf; // metres
uniform vec3 uSun;
uniform float uReach;    // metres: the longest shadow
uniform float uSkyReach; // metres: no farther hill takes sky away
in vec2 vPlace;
out vec4 oLight;

const int SunSteps = 36;
const int SkyDirections = 8;
const int SkySteps = 5;

void main()
{
    float texel = 2.0 * max(uHalf.x, uHalf.y) / float(textureSize(uHeights, 0).x);
    float height = texture(uHeights, vPlace).r;
    vec2 scale = 0.5 / uHalf; // metres to texture

    float horizon = -1e3;
    vec2 towards = normalize(uSun.xz);
    for (int i = 0; i < SunSteps; ++i) {
        float t = (float(i) + 0.5) / float(SunSteps);
        float away = 1.5 * texel + uReach * t * t;
        vec2 place = vPlace + towards * away * scale;
        if (any(greaterThan(abs(place - 0.5), vec2(0.5))))
            break;
        horizon = max(horizon, (textureLod(uHeights, place, 0.0).r - height) / away);
    }
    float elevation = uSun.y / length(uSun.xz);
    float soft = 0.10 * elevation + 0.02;
    float sun = 1.0 - smoothstep(elevation - soft, elevation + soft, horizon);

    float hidden = 0.0;
    for (int d = 0; d < SkyDirections; ++d) {
        float angle = 6.2831853 * (float(d) + 0.5) / float(SkyDirections);
        vec2 direction = vec2(cos(angle), sin(angle));
        float highest = 0.0;
        float away = 2.0 * texel;
        float growth = pow(max(uSkyReach / away, 1.0), 1.0 / float(SkySteps - 1));
        for (int i = 0; i < SkySteps; ++i) {
            vec2 place = clamp(vPlace + direction * away * scale, vec2(0.0), vec2(1.0));
            highest = max(highest, (textureLod(uHeights, place, 0.0).r - height) / away);
            away *= growth;
        }
        hidden += highest * highest / (1.0 + highest * highest); // squared sine: light counts by the cosine
    }
    oLight = vec4(sun, 1.0 - hidden / float(SkyDirections), 0.0, 1.0);
}
