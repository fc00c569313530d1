// SPDX-License-Identifier: GPL-3.0-or-later
// Light that goes with the camera, and the way from linear light to the screen. Vectors are in view space: x right,
// y up, z towards the viewer.

const vec3 KeyDirection = vec3(-0.488, 0.683, 0.543);
const vec3 KeyColor = vec3(1.00, 0.965, 0.90) * 1.75;
const vec3 FillDirection = vec3(0.857, 0.065, 0.511);
const vec3 FillColor = vec3(0.70, 0.82, 1.00) * 0.42;
const vec3 RimDirection = vec3(0.338, 0.482, -0.808);
const vec3 RimColor = vec3(0.85, 0.93, 1.00) * 1.3;
const vec3 SkyColor = vec3(0.80, 0.90, 1.00) * 0.34;
const vec3 GroundColor = vec3(0.52, 0.42, 0.36) * 0.16;

float wrapped(float cosine, float wrap)
{
    float light = max((cosine + wrap) / (1.0 + wrap), 0.0);
    return light * light;
}

// albedo, result: linear. normal, toViewer: unit, the normal on the viewer's side. up: the world's up.
vec3 lit(vec3 albedo, vec3 normal, vec3 toViewer, vec3 up)
{
    vec3 light = mix(GroundColor, SkyColor, 0.5 + 0.5 * dot(normal, up));
    light += KeyColor * wrapped(dot(normal, KeyDirection), 0.35);
    light += FillColor * wrapped(dot(normal, FillDirection), 0.5);
    float facing = clamp(dot(normal, toViewer), 0.0, 1.0);
    float grazing = pow(1.0 - facing, 4.0);
    light += RimColor * grazing * wrapped(dot(normal, RimDirection), 0.8);
    // Hollows and grazing parts get less of the surroundings: a hint of ambient occlusion.
    light *= mix(0.62, 1.0, smoothstep(0.0, 0.55, facing));
    vec3 color = albedo * light;
    float gloss = pow(max(dot(normal, normalize(KeyDirection + toViewer)), 0.0), 48.0);
    color += KeyColor * gloss * 0.09;
    return color;
}

uniform float uErrorRange;     // the error that has the last colour; 0: surfaces have their own colour
uniform vec3 uErrorColors[9];  // linear, from no error to the largest

vec3 errorColor(float error)
{
    float place = clamp(error / uErrorRange, 0.0, 1.0) * 8.0;
    int below = min(int(place), 7);
    return mix(uErrorColors[below], uErrorColors[below + 1], place - float(below));
}

vec3 toSrgb(vec3 color)
{
    vec3 low = color * 12.92;
    vec3 high = 1.055 * pow(max(color, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055;
    return mix(low, high, step(vec3(0.0031308), color));
}

// Rolls highlights off, encodes for the screen, and dithers: 8 bits would show bands in soft gradients.
vec4 encoded(vec3 color)
{
    color = color * (1.0 + color * 0.06) / (1.0 + color * 0.30);
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return vec4(toSrgb(color) + (noise - 0.5) / 255.0, 1.0);
}
