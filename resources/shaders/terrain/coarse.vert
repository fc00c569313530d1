// SPDX-License-Identifier: GPL-3.0-or-later
// A grid of squares over the maps, two triangles each; no vertex data.
uniform mat4 uView;
uniform mat4 uProjection;
uniform vec2 uHalf; // metres
uniform int uSquares; // along a side
uniform sampler2D uHeights;
uniform sampler2D uPaint;
uniform sampler2D uNumbers;
out vec3 vPlace;
out vec3 vNormal;
out vec4 vColor;
out float vNumber;
out vec2 vSlide;
out float vHole; // above 0: there is no ground

float heightAt(vec2 share)
{
    return textureLod(uHeights, share, 0.0).r;
}

void main()
{
    int square = gl_VertexID / 6, corner = gl_VertexID % 6;
    ivec2 offset = ivec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
    ivec2 cell = ivec2(square % uSquares, square / uSquares) + offset;
    float texel = 1.0 / float(textureSize(uHeights, 0).x);
    vec2 share = clamp(vec2(cell) / float(uSquares), vec2(0.5 * texel), vec2(1.0 - 0.5 * texel));
    float height = heightAt(share);
    vec2 apart = vec2(0.5 / float(uSquares));
    vec2 low = max(share - apart, vec2(0.5 * texel)), high = min(share + apart, vec2(1.0 - 0.5 * texel));
    vec2 rise = vec2(heightAt(vec2(high.x, share.y)) - heightAt(vec2(low.x, share.y)),
                     heightAt(vec2(share.x, high.y)) - heightAt(vec2(share.x, low.y)));
    vec2 slope = rise / ((high - low) * 2.0 * uHalf);
    vHole = height < -1e8 ? 1.0 : 0.0;
    vPlace = vec3((vec2(cell) / float(uSquares) * 2.0 - 1.0) * uHalf, max(height, -1e8)).xzy;
    vNormal = normalize(vec3(-slope.x, 1.0, -slope.y));
    vColor = textureLod(uPaint, share, 0.0);
    vSlide = vec2(0.0); // nobody sees single grains in it
    vNumber = textureLod(uNumbers, share, 0.0).r;
    gl_Position = uProjection * (uView * vec4(vHole > 0.0 ? vec3(vPlace.x, 0.0, vPlace.z) : vPlace, 1.0));
}
