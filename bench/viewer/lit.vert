// Hands a lit primitive's surface on to lit.frag. World space throughout.
uniform mat4 uViewProjection;

#ifdef POINTS
in vec2 aScreen;  // where a point's own triangle is drawn
#endif

in vec3 aPosition;
in vec3 aNormal;
in vec4 aTangent;         // glTF's TANGENT: w is the bitangent's sign
in vec2 aBaseTexcoord, aNormalTexcoord, aEmissiveTexcoord;
in vec2 aLightTexcoord;   // [0, 1] of the atlas
in vec4 aLightRectangle;  // left, top, width, height in the atlas, pixels
in vec4 aColor;

out vec3 vPosition, vNormal;
out vec4 vTangent, vColor;
out vec2 vBaseTexcoord, vNormalTexcoord, vEmissiveTexcoord, vLightTexcoord;
flat out vec4 vLightRectangle;

void main() {
#ifdef HEMISPHERE
    gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);  // one triangle over all
    return;
#endif
    vPosition = aPosition;
    vNormal = aNormal;
    vTangent = aTangent;
    vColor = aColor;
    vBaseTexcoord = aBaseTexcoord;
    vNormalTexcoord = aNormalTexcoord;
    vEmissiveTexcoord = aEmissiveTexcoord;
    vLightTexcoord = aLightTexcoord;
    vLightRectangle = aLightRectangle;
#ifdef POINTS
    gl_Position = vec4(aScreen, 0.0, 1.0);
#else
    gl_Position = uViewProjection * vec4(aPosition, 1.0);
#endif
}
