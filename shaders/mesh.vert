// SPDX-License-Identifier: MIT
// The shell: each triangle has its own three vertices, so that the fragment stage knows how far each
// edge is.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 edges; // what the edge opposite each vertex is; distance from the nearest crease
layout(location = 3) in uint polygonState;

uniform mat4 view;
uniform mat4 projection;

out vec3 eyePosition;
out vec3 eyeNormal;
out vec3 barycentric;
flat out vec3 edgeStrengths;
out float creaseDistance;
flat out uint state;

void main()
{
    vec4 eye = view * vec4(position, 1.0);
    eyePosition = eye.xyz;
    eyeNormal = mat3(view) * normal;
    int vertex = gl_VertexID % 3;
    barycentric = vec3(vertex == 0, vertex == 1, vertex == 2);
    edgeStrengths = edges.xyz;
    creaseDistance = edges.w;
    state = polygonState;
    gl_Position = projection * eye;
}
