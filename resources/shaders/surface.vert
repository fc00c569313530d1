// SPDX-License-Identifier: GPL-3.0-or-later
uniform mat4 uView;
uniform mat4 uProjection;
out vec3 vNormal;   // view space
out vec3 vPosition; // view space
out float vError;

#ifdef EDGES
// One call a corner, so that each knows its place in its triangle: the arrays are read as textures.
uniform usamplerBuffer uTriangles;
uniform samplerBuffer uPositions;
uniform samplerBuffer uNormals;
uniform samplerBuffer uErrors;
uniform bool uHasErrors;
out vec3 vCorner;

vec3 fetched(samplerBuffer numbers, int index)
{
    return vec3(texelFetch(numbers, 3 * index).r, texelFetch(numbers, 3 * index + 1).r,
                texelFetch(numbers, 3 * index + 2).r);
}
#else
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in float aError;
#endif

void main()
{
#ifdef EDGES
    int vertex = int(texelFetch(uTriangles, gl_VertexID).r);
    vec3 position = fetched(uPositions, vertex);
    vec3 normal = fetched(uNormals, vertex);
    vError = uHasErrors ? texelFetch(uErrors, vertex).r : 0.0;
    int corner = gl_VertexID % 3;
    vCorner = vec3(corner == 0, corner == 1, corner == 2);
#else
    vec3 position = aPosition;
    vec3 normal = aNormal;
    vError = aError;
#endif
    vec4 place = uView * vec4(position, 1.0);
    vPosition = place.xyz;
    vNormal = mat3(uView) * normal;
    gl_Position = uProjection * place;
}
