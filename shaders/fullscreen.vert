#version 330 core
// One triangle that covers the target; no vertex buffer. Row 0 of the picture is the top row, and texelFetch in the
// fragment shader counts from it, so nothing is flipped here.

void main() {
    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
