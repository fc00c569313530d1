// SPDX-License-Identifier: GPL-3.0-or-later
// The ground. Vectors are in the scene's axes: y up, z south. Light is linear.
uniform vec3 uEye;
uniform vec3 uSun;  // towards it, unit
uniform vec2 uHalf; // metres: half of the terrain's sides
uniform bool uHasMaps;
uniform sampler2D uLight;  // visible sun, visible sky; see light.frag
uniform sampler2D uGrains; // slope in x and y, height, a random number; tiles
uniform float uTile;       // metres: side of a tile of grains
uniform float uSlideReach; // metres that detail travels with the sand
uniform float uContour;    // metres between contours; 0: none
uniform float uContourPhase;
in vec3 vPlace;
in vec3 vNormal;
in vec4 vColor;
in float vNumber;
in vec2 vSlide;
out vec4 oColor;

const vec3 SunColor = vec3(1.00, 0.90, 0.74) * 1.85;
const vec3 ZenithColor = vec3(0.56, 0.72, 1.00) * 0.36;
const vec3 BounceColor = vec3(0.95, 0.70, 0.44) * 0.11;

vec3 toLight(vec3 srgb)
{
    return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), srgb));
}

#ifdef EDGES
in vec3 vCorner;

float edgeCoverage()
{
    vec3 slope = sqrt(dFdx(vCorner) * dFdx(vCorner) + dFdy(vCorner) * dFdy(vCorner));
    vec3 pixels = vCorner / max(slope, vec3(1e-9));
    vec3 heights = 1.0 / max(slope, vec3(1e-9));
    float nearest = min(pixels.x, min(pixels.y, pixels.z));
    float smallest = min(heights.x, min(heights.y, heights.z));
    return (1.0 - smoothstep(0.05, 1.05, nearest)) * clamp(smallest / 5.0, 0.12, 1.0);
}
#endif

#ifdef COARSE
in float vHole;
#endif

#ifdef DETAIL
// Slope of the grains over one plane, and their height and random number, at a scale and turned by an angle.
vec4 grains(vec2 plane, float tile, vec2 turn)
{
    vec2 turned = vec2(plane.x * turn.x - plane.y * turn.y, plane.x * turn.y + plane.y * turn.x) / tile;
    vec4 grain = texture(uGrains, turned) * 2.0 - 1.0;
    grain.xy = vec2(grain.x * turn.x + grain.y * turn.y, grain.y * turn.x - grain.x * turn.y);
    return grain;
}

// Both scales: single grains, and the clods and streaks they lie in.
vec4 grainsAndClods(vec2 plane)
{
    vec4 fine = grains(plane, uTile, vec2(0.921, 0.390));
    vec4 coarse = grains(plane, uTile * 7.3, vec2(0.602, 0.799));
    return vec4(fine.xy * 0.62 + coarse.xy * 0.34, fine.z * 0.6 + coarse.z * 0.4, fine.w);
}

// No texture coordinates on a TIN: three projections, by how far the ground faces each.
vec4 detailAt(vec3 place, vec3 normal, out vec3 bump)
{
    vec3 weights = pow(abs(normal), vec3(6.0));
    weights /= weights.x + weights.y + weights.z;
    vec4 sum = grainsAndClods(place.xz);
    bump = vec3(sum.x, 0.0, sum.y);
#ifdef TRIPLANAR
    sum *= weights.y;
    bump *= weights.y;
    if (weights.x > 0.03) {
        vec4 side = grainsAndClods(place.zy);
        sum += side * weights.x;
        bump += vec3(0.0, side.y, side.x) * weights.x;
    }
    if (weights.z > 0.03) {
        vec4 side = grainsAndClods(place.xy);
        sum += side * weights.z;
        bump += vec3(side.x, side.y, 0.0) * weights.z;
    }
#endif
    return sum;
}

// Detail that travels with the sand. Two copies of it do, half a reach apart; each fades out where it is taken back, so
// that it never smears however far the sand goes. Source: N. Max, B. Becker, Flow Visualization Using Moving Textures,
// 1995. Differs: the way is kept at the vertices, and detail is worn down where that differs too much between them.
vec4 detail(vec3 normal, out vec3 bump)
{
    float slid = length(vSlide);
    if (slid < 0.01)
        return detailAt(vPlace, normal, bump);
    vec2 towards = vSlide / slid;
    float down = clamp(dot(normal.xz, towards) / max(normal.y, 0.2), -2.0, 2.0);
    vec3 way = vec3(towards.x, -down, towards.y) * uSlideReach;
    vec2 phase = fract(vec2(slid, slid + 0.5));
    vec2 weights = 1.0 - abs(2.0 * phase - 1.0);
    weights /= length(weights); // as rough together as one alone
    vec3 firstBump, secondBump;
    vec4 first = detailAt(vPlace - way * (phase.x - 0.5), normal, firstBump);
    vec4 second = detailAt(vPlace - way * (phase.y - 0.5), normal, secondBump);
    float pixel = max(max(length(dFdx(vPlace)), length(dFdy(vPlace))), 1e-9);
    float stretch = max(length(dFdx(vSlide)), length(dFdy(vSlide))) * uSlideReach / pixel;
    float kept = 1.0 - 0.75 * smoothstep(0.4, 1.4, stretch);
    bump = (firstBump * weights.x + secondBump * weights.y) * kept;
    return (first * weights.x + second * weights.y) * kept;
}
#endif

#ifdef TRIPLANAR
// What the wind makes: crests across it, bent by the clods, where the ground is gentle.
vec2 ripples(vec3 normal, out float crest)
{
    // The coarse levels of the tile are smooth: they bend the crests, and let them fade here and there.
    float bend = textureLod(uGrains, vPlace.xz / (uTile * 41.0), 4.0).z - 0.5;
    float calm = textureLod(uGrains, vPlace.zx / (uTile * 29.0) + 0.37, 4.0).z - 0.5;
    float wave = uTile * 0.40;
    vec2 across = vec2(0.80, 0.60);
    float phase = (dot(vPlace.xz, across) / wave + bend * 13.0) * 6.2831853;
    float pixels = 6.2831853 / max(fwidth(phase), 1e-4); // of one ripple
    float strength = smoothstep(0.88, 0.97, normal.y) * smoothstep(3.0, 9.0, pixels) * smoothstep(-0.06, 0.05, calm);
    strength *= 1.0 - smoothstep(0.03, 0.35, length(vSlide)); // sliding wipes them out
    crest = (sin(phase) + 0.25 * sin(2.0 * phase + 0.9)) * strength;
    return -across * (cos(phase) + 0.5 * cos(2.0 * phase + 0.9)) * strength;
}

// Single grains that mirror the sun.
float glints(vec3 normal, vec3 toEye, float sun)
{
    vec2 cells = vPlace.xz / uTile * 300.0;
    float size = max(length(dFdx(cells)), length(dFdy(cells)));
    if (size > 2.5 || sun <= 0.0)
        return 0.0;
    vec2 cell = floor(cells);
    vec3 random = fract(sin(vec3(dot(cell, vec2(127.1, 311.7)), dot(cell, vec2(269.5, 183.3)),
                                 dot(cell, vec2(419.2, 371.9)))) * 43758.5453);
    vec3 facet = normalize(normal + (random - 0.5) * 1.7);
    float mirrored = max(dot(facet, normalize(uSun + toEye)), 0.0);
    return pow(mirrored, 400.0) * 3.0 * smoothstep(0.1, 0.4, sun) * (1.0 - smoothstep(1.0, 2.5, size));
}
#endif

float contourCoverage()
{
    float level = vPlace.y / uContour + uContourPhase;
    float slope = max(fwidth(level), 1e-9);
    float line = abs(fract(level + 0.5) - 0.5) / slope;
    bool isMajor = mod(floor(level + 0.5), 5.0) == 0.0;
    float coverage = 1.0 - smoothstep(isMajor ? 0.7 : 0.25, isMajor ? 1.5 : 1.05, line);
    return coverage * (isMajor ? 0.8 : 0.5) * (1.0 - smoothstep(0.2, 0.6, slope));
}

#ifdef OVERLAY
uniform int uKind;        // 1 height, 2 slope, 3 humidity, 4 the vertices' number
uniform vec2 uRange;      // what has the first and the last colour
uniform vec3 uColors[9];  // sRGB

vec3 mapped(float value)
{
    float place = clamp((value - uRange.x) / (uRange.y - uRange.x), 0.0, 1.0) * 8.0;
    int below = min(int(place), 7);
    return mix(uColors[below], uColors[below + 1], place - float(below));
}

float overlayValue()
{
    if (uKind == 1)
        return vPlace.y;
    if (uKind == 2) { // that of the triangle
        vec3 face = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
        return degrees(acos(min(abs(face.y), 1.0)));
    }
    return uKind == 3 ? vColor.a : vNumber;
}
#endif

void main()
{
#ifdef COARSE
    if (vHole > 0.0)
        discard;
#endif
    vec3 normal = normalize(vNormal);
    vec2 light = uHasMaps ? texture(uLight, vPlace.xz / uHalf * 0.5 + 0.5).rg : vec2(1.0);
#ifdef OVERLAY
    // Level ground has the colour of the legend; slopes a hint of their shape.
    float shade = max(dot(normal, uSun), 0.0) / uSun.y;
    vec3 color = mapped(overlayValue()) * clamp(0.55 + 0.45 * shade, 0.5, 1.15) * mix(0.85, 1.0, light.g);
#else
    vec3 albedo = toLight(vColor.rgb);
    float wet = smoothstep(0.02, 0.75, vColor.a);
    vec3 toEye = normalize(uEye - vPlace);
    vec3 shaded = normal;
    float sparkle = 0.0;
#ifdef DETAIL
    vec3 bump;
    vec4 grain = detail(normal, bump);
    float dry = 1.0 - 0.55 * wet;
    shaded = normalize(normal + bump * 0.55 * dry);
    albedo *= 1.0 + 0.30 * grain.z * dry;
    albedo *= mix(vec3(1.0), vec3(1.10, 0.98, 0.86), clamp(grain.w * 0.5 * grain.z + 0.1, 0.0, 1.0));
#endif
#ifdef TRIPLANAR
    float crest;
    vec2 wind = ripples(normal, crest) * (1.0 - wet);
    shaded = normalize(shaded + vec3(wind.x, 0.0, wind.y) * 0.20);
    albedo *= 1.0 + 0.05 * crest * (1.0 - wet);
    sparkle = glints(shaded, toEye, light.r * dot(normal, uSun)) * (1.0 - wet);
#endif
    // Water between the grains: light comes out later, and more of it is lost. Source: J. Lekner, M. Dorf, Why Some
    // Things Are Darker When Wet, 1988.
    albedo = mix(albedo, pow(albedo, vec3(1.25)) * vec3(0.50, 0.47, 0.45), wet);
#ifdef REFERENCE
    // The recipe of the references: bump map, Lambert, then the middle of the histogram stretched, 0.3 cut at each end.
    float lambert = max(dot(shaded, uSun), 0.0);
    vec3 plain = toSrgb(albedo) * (0.42 + 0.58 * lambert);
    vec3 color = clamp((plain - 0.3) / 0.4, 0.0, 1.0);
#else
    // Grains let light through and scatter it: the terminator is soft, and warm.
    float facing = dot(shaded, uSun);
    vec3 scatter = vec3(0.26, 0.17, 0.10) * (1.0 - 0.5 * wet);
    vec3 sun = max((facing + scatter) / (1.0 + scatter), 0.0);
    sun *= sun * 0.25 + 0.75; // rough grains shade each other at grazing light
    vec3 sky = ZenithColor * (0.5 + 0.5 * shaded.y) * light.g;
    vec3 bounce = BounceColor * (1.0 - 0.5 * normal.y) * (0.4 + 0.6 * light.r) * (2.0 - light.g);
    vec3 sum = albedo * (SunColor * sun * light.r + sky + bounce);
    float gloss = pow(max(dot(normalize(mix(normal, shaded, 0.4)), normalize(uSun + toEye)), 0.0), 60.0);
    sum += SunColor * gloss * light.r * mix(0.012, 0.22, wet);
    float rim = pow(1.0 - clamp(dot(normal, toEye), 0.0, 1.0), 4.0);
    sum += ZenithColor * rim * (0.10 + 0.25 * wet) * light.g;
    sum += SunColor * sparkle * light.r;
    vec3 color = encoded(sum).rgb;
#endif
#endif
    if (uContour > 0.0)
        color = mix(color, vec3(0.10, 0.07, 0.05), contourCoverage());
#ifdef EDGES
    color = mix(color, vec3(0.08, 0.07, 0.06), edgeCoverage() * 0.75);
#endif
    oColor = vec4(color, 1.0);
}
