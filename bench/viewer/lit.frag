// Irradiance of the fragment's normal from the light map, as the paper's fragment program finds it: "we evaluate the
// SH basis functions for the normal of the fragment" (Good and Taylor 2005).
//
// Before this text stand, made by shading.js and by the program: HARMONICS, HEMISPHERE_FIT, LUMINANCE_FIT
// or AMBIENT_AND_DIRECTION (one of them is defined); COUNT, harmonics that are evaluated; LAYERS, of the texture; EXACT or
// not; MEASURE (numbers in place of colours; with POINTS, of single points), HEMISPHERE (one texel's light for all normals) or neither; and the
// constants C0 to C44 and SAME_SURFACE_COSINE.

uniform highp sampler2DArray uLight;  // numbers of the texels, four a layer
uniform highp sampler2D uFaces;       // unit normal and covered area of the texels
uniform highp sampler2D uHits;
uniform vec2 uAtlasSize;              // pixels
uniform float uUnit;                  // W/m^2 of the numbers of light

uniform vec4 uBaseColor;
uniform bool uHasBaseTexture, uHasNormalMap, uHasEmissiveTexture, uIsStored;
uniform sampler2D uBaseTexture, uEmissiveTexture;
uniform highp sampler2D uNormalMap;
uniform ivec2 uNormalMapWrap;         // 0 repeat, 1 clamp to edge, 2 mirrored repeat
uniform bool uNormalMapNearest;
uniform float uNormalMapScale;        // glTF's, times the slider
uniform vec3 uEmitted;                // W/(m^2 sr)
uniform float uAlphaCutoff;           // below it there is a hole
uniform vec2 uTilt;                   // angle off the normal and turn around it, radians
uniform float uExposure;
uniform int uShow;
uniform float uMostHits;              // on any texel

in vec3 vPosition, vNormal;
in vec4 vTangent, vColor;
in vec2 vBaseTexcoord, vNormalTexcoord, vEmissiveTexcoord, vLightTexcoord;
flat in vec4 vLightRectangle;

#ifdef MEASURE
layout(location = 0) out vec4 oIrradiance;
layout(location = 1) out vec4 oPosition;
layout(location = 2) out vec4 oPlace;   // in the atlas, pixels; left and top of its rectangle
layout(location = 3) out vec4 oNormal;  // and 1 where there are texels
#else
out vec4 oColor;
#endif

const float PI = 3.14159265358979;
const int SHOW_LIT = 0, SHOW_IRRADIANCE = 1, SHOW_TEXELS = 2, SHOW_HITS = 3, SHOW_CLAMPED = 4, SHOW_FILTERS = 5, SHOW_NORMALS = 6;

// --- harmonics: shlm/basis/sh_basis.h

void harmonics(vec3 d, out float y[COUNT]) {
    y[0] = C0;
#if COUNT >= 4
    y[1] = C1 * d.y;
    y[2] = C1 * d.z;
    y[3] = C1 * d.x;
#endif
#if COUNT >= 9
    float xx = d.x * d.x, yy = d.y * d.y, zz = d.z * d.z, xy = d.x * d.y, yz = d.y * d.z, xz = d.x * d.z;
    y[4] = C2 * xy;
    y[5] = C2 * yz;
    y[6] = C20 * (3.0 * zz - 1.0);
    y[7] = C2 * xz;
    y[8] = C22 * (xx - yy);
#endif
#if COUNT >= 18
    y[9] = 4.0 * C44 * xy * (xx - yy);
    y[10] = C43 * yz * (3.0 * xx - yy);
    y[11] = 2.0 * C42 * xy * (7.0 * zz - 1.0);
    y[12] = C41 * yz * (7.0 * zz - 3.0);
    y[13] = C40 * (35.0 * zz * zz - 30.0 * zz + 3.0);
    y[14] = C41 * xz * (7.0 * zz - 3.0);
    y[15] = C42 * (xx - yy) * (7.0 * zz - 1.0);
    y[16] = C43 * xz * (xx - 3.0 * yy);
    y[17] = C44 * (xx * (xx - 3.0 * yy) - yy * (3.0 * xx - yy));
#endif
}

// --- bases: shlm/basis

float gY[COUNT];  // harmonics of the fragment's normal

#define NUMBER(i) (layer[(i) / 4][(i) % 4])
#define RGB_AT(i) vec3(NUMBER(i), NUMBER((i) + 1), NUMBER((i) + 2))

#if (defined(HEMISPHERE_FIT) || defined(LUMINANCE_FIT)) && COUNT >= 4
// Factors of the coefficients of irradiance: shlm/basis/clamped_cosine.h over the factors of the clamped cosine.
void fittedFactors(vec3 face, vec3 n, out float q[COUNT]) {
    float c = dot(face, n);
    vec3 t = n - face * c;
    float s_sq = dot(t, t), s = sqrt(s_sq), beta = atan(s, c);
    float e = c > 0.0 ? s_sq / (1.0 + c) : 1.0 - c, g = 2.0 / (3.0 * PI) * (s - beta * c);
#if COUNT == 4
    float constant = e - 3.0 * g;
    vec3 linear = n + face * (6.0 * g - 1.5 * e) - t * (beta / PI);
#else
    float constant = (4.75 + 5.625 * e) * e - 48.0 * g;
    vec3 linear = n + face * (96.0 * g - (9.0 + 11.25 * e) * e) + t * ((22.5 * e - 64.0 / PI * beta) / 19.0);
#endif
    q[0] = constant / (PI * C0);
    linear /= PI * 2.0 / 3.0 * C1;
    q[1] = linear.y;
    q[2] = linear.z;
    q[3] = linear.x;
#if COUNT == 9
    float along = (5.0 + 7.5 * e) * e - 60.0 * g, across = (120.0 / PI * beta - 60.0 * e) / 19.0, around = 15.0 / 64.0;
    mat3 S = (1.5 * along + around * s_sq) * outerProduct(face, face) + across / 2.0 * (outerProduct(face, t) + outerProduct(t, face))
           + 2.0 * around * outerProduct(t, t) - (along / 2.0 + around * s_sq) * mat3(1.0);
    S /= PI / 4.0;
    q[4] = 2.0 * S[0][1] / C2;
    q[5] = 2.0 * S[1][2] / C2;
    q[6] = S[2][2] / (2.0 * C20);
    q[7] = 2.0 * S[0][2] / C2;
    q[8] = (S[0][0] - S[1][1]) / (2.0 * C22);
#endif
}
#endif

// What a texel's numbers say of the normal `n`, in units; `face` is the texel's own normal. May be negative.
vec3 seriesOf(vec4 layer[LAYERS], vec3 face, vec3 n) {
#if defined(HARMONICS)
    vec3 sum = vec3(0.0);
    for (int i = 0; i < COUNT; ++i) sum += RGB_AT(3 * i) * gY[i];
    return sum;
#elif defined(AMBIENT_AND_DIRECTION)
    vec3 direct = RGB_AT(3);
    return RGB_AT(0) * ((1.0 - dot(direct, face)) * (1.0 + dot(n, face)) / 2.0 + max(dot(direct, n), 0.0));
#elif defined(HEMISPHERE_FIT) && COUNT == 1
    return RGB_AT(0) * ((1.0 + dot(n, face)) / 2.0);
#elif defined(HEMISPHERE_FIT)
    float q[COUNT];
    fittedFactors(face, n, q);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < COUNT; ++i) sum += RGB_AT(3 * i) * q[i];
    return sum;
#elif defined(LUMINANCE_FIT)
    float q[COUNT];
    fittedFactors(face, n, q);
    float mean = 0.0;
    for (int i = 0; i < COUNT; ++i) mean += NUMBER(i) * q[i];
    float red = NUMBER(COUNT), green = NUMBER(COUNT + 1);
    return vec3(red, green, max(3.0 - red - green, 0.0)) * mean;
#endif
}

// --- filters. Both give the series before it is cut off at zero, in units.

// Four fetches weighted by covered area, without texels that look another way: as the program's "bilinear".
vec3 exactSeries(vec3 n, vec3 geometric) {
    vec2 at = vLightTexcoord * uAtlasSize - vLightRectangle.xy - 0.5, first = floor(at), beyond = at - first;
    ivec2 corner = ivec2(vLightRectangle.xy), size = ivec2(vLightRectangle.zw);
    vec3 sum = vec3(0.0);
    float weight = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i % 2, i / 2), texel = ivec2(first) + step;
        if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size))) continue;
        vec4 face = texelFetch(uFaces, corner + texel, 0);
        if (face.w <= 0.0 || dot(face.xyz, geometric) <= SAME_SURFACE_COSINE) continue;
        vec2 share = mix(1.0 - beyond, beyond, vec2(step));
        vec4 layer[LAYERS];
        for (int l = 0; l < LAYERS; ++l) layer[l] = texelFetch(uLight, ivec3(corner + texel, l), 0);
        sum += seriesOf(layer, face.xyz, n) * (share.x * share.y * face.w);
        weight += share.x * share.y * face.w;
    }
    return weight == 0.0 ? vec3(0.0) : sum / weight;
}

// The texture unit mixes the numbers, as engines let it: one fetch a layer, and the surface's own normal as the texel's.
vec3 hardwareSeries(vec3 n, vec3 smooth_normal) {
    vec2 at = clamp(vLightTexcoord * uAtlasSize, vLightRectangle.xy, vLightRectangle.xy + vLightRectangle.zw) / uAtlasSize;
    vec4 layer[LAYERS];
    for (int l = 0; l < LAYERS; ++l) layer[l] = texture(uLight, vec3(at, float(l)));
    return seriesOf(layer, smooth_normal, n);
}

// --- normals: common/scene/surface_point.cpp

ivec2 wrapped(ivec2 texel, ivec2 size) {
    for (int axis = 0; axis < 2; ++axis)
        texel[axis] = uNormalMapWrap[axis] == 0 ? (texel[axis] + size[axis]) % size[axis] : clamp(texel[axis], 0, size[axis] - 1);
    return texel;
}

float placed(float coordinate, int wrap) {
    if (wrap == 0) return coordinate - floor(coordinate);
    if (wrap == 1) return clamp(coordinate, 0.0, 1.0);
    float in_period = coordinate - 2.0 * floor(coordinate / 2.0);
    return in_period <= 1.0 ? in_period : 2.0 - in_period;
}

// Filtered here and not by the texture unit, whose weights have 8 bits.
vec3 normalTexel(vec2 texcoord) {
#ifndef EXACT
    return texture(uNormalMap, texcoord).xyz;
#endif
    ivec2 size = textureSize(uNormalMap, 0);
    vec2 at = vec2(placed(texcoord.x, uNormalMapWrap.x), placed(texcoord.y, uNormalMapWrap.y)) * vec2(size) - 0.5;
    vec2 first = floor(at), beyond = uNormalMapNearest ? step(0.5, at - first) : at - first;
    ivec2 a = wrapped(ivec2(first), size), b = wrapped(ivec2(first) + 1, size);
    vec3 upper = mix(texelFetch(uNormalMap, a, 0).xyz, texelFetch(uNormalMap, ivec2(b.x, a.y), 0).xyz, beyond.x);
    vec3 lower = mix(texelFetch(uNormalMap, ivec2(a.x, b.y), 0).xyz, texelFetch(uNormalMap, b, 0).xyz, beyond.x);
    return mix(upper, lower, beyond.y);
}

vec3 bent(vec3 normal) {
    vec3 texel = 2.0 * normalTexel(vNormalTexcoord) - 1.0;
    texel.xy *= uNormalMapScale;
    vec3 tangent = vTangent.xyz - normal * dot(normal, vTangent.xyz);
    tangent = dot(tangent, tangent) > 0.0 ? normalize(tangent) : vec3(0.0);
    vec3 result = tangent * texel.x + cross(normal, tangent) * (vTangent.w * texel.y) + normal * texel.z;
    return dot(result, result) > 0.0 ? normalize(result) : normal;
}

vec3 tilted(vec3 n) {
    if (uTilt.x == 0.0) return n;
    vec3 across = normalize(cross(n, abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    vec3 way = across * cos(uTilt.y) + cross(n, across) * sin(uTilt.y);
    return n * cos(uTilt.x) + way * sin(uTilt.x);
}

// --- colours

vec3 displayed(vec3 radiance) {
    vec3 x = max(radiance * uExposure, 0.0);
    x = min(x * (1.0 + x / 16.0) / (1.0 + x), 1.0);  // as the program's PNGs: 4 times white becomes white
    return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, x));
}

// From dark blue by green to yellow, in [0, 1].
vec3 scaleColor(float x) {
    x = clamp(x, 0.0, 1.0);
    return clamp(vec3(1.9 * x - 0.75, 0.05 + 0.95 * x, 0.35 + 0.9 * x * (1.0 - 1.45 * x)), 0.0, 1.0);
}

vec3 texelColor() {
    ivec2 texel = ivec2(floor(vLightTexcoord * uAtlasSize - vLightRectangle.xy));
    bool border = any(equal(texel, ivec2(0))) || any(equal(texel, ivec2(vLightRectangle.zw) - 1));
    float checker = float((texel.x + texel.y) & 1);
    return border ? vec3(0.9, 0.45, 0.1) * (0.7 + 0.3 * checker) : vec3(0.35 + 0.3 * checker);
}

vec3 hitsColor() {
    ivec2 texel = ivec2(floor(clamp(vLightTexcoord * uAtlasSize, vLightRectangle.xy, vLightRectangle.xy + vLightRectangle.zw - 1.0)));
    float hits = texelFetch(uHits, texel, 0).x;
    return hits == 0.0 ? vec3(0.5, 0.0, 0.35) : scaleColor(log2(1.0 + hits) / log2(2.0 + uMostHits));
}

#ifdef HEMISPHERE
uniform ivec2 uTexel;
uniform vec3 uAcross;    // unit, in the texel's surface
uniform float uDiameter; // of the disc, pixels

// The disc shows the normals above the texel's surface, its own in the middle: distance is the sine of the angle.
void main() {
    vec2 at = 2.0 * gl_FragCoord.xy / uDiameter - 1.0;
    float rest = 1.0 - dot(at, at);
    if (rest < 0.0) { oColor = vec4(0.0); return; }
    vec3 face = texelFetch(uFaces, uTexel, 0).xyz, along = cross(face, uAcross);
    vec3 n = uAcross * at.x + along * at.y + face * sqrt(rest);
    harmonics(n, gY);
    vec4 layer[LAYERS];
    for (int l = 0; l < LAYERS; ++l) layer[l] = texelFetch(uLight, ivec3(uTexel, l), 0);
    vec3 series = seriesOf(layer, face, n) * uUnit;
    oColor = vec4(min(series.r, min(series.g, series.b)) < 0.0 ? vec3(0.75, 0.1, 0.1) : displayed(series / PI), 1.0);
}
#else
void main() {
    vec4 base = uBaseColor * vColor;
    if (uHasBaseTexture) base *= texture(uBaseTexture, vBaseTexcoord);
    if (base.a < uAlphaCutoff) discard;

    vec3 geometric = normalize(cross(dFdx(vPosition), dFdy(vPosition)));  // on the side that is seen
    vec3 smooth_normal = dot(vNormal, geometric) > 0.0 ? normalize(vNormal) : geometric;
    vec3 n = uHasNormalMap ? bent(smooth_normal) : smooth_normal;
    n = tilted(n);
    if (dot(n, geometric) <= 0.0) n = geometric;

    bool has_texels = uIsStored && vLightRectangle.z > 0.0;
    harmonics(n, gY);
#ifdef EXACT
    vec3 series = has_texels ? exactSeries(n, geometric) : vec3(0.0);
#else
    vec3 series = has_texels ? hardwareSeries(n, smooth_normal) : vec3(0.0);
#endif
    vec3 irradiance = max(series, 0.0) * uUnit;

#ifdef MEASURE
    oIrradiance = vec4(irradiance, 1.0);
    oPosition = vec4(vPosition, 1.0);
    oPlace = vec4(vLightTexcoord * uAtlasSize, vLightRectangle.xy);
    oNormal = vec4(n, has_texels ? 1.0 : 0.0);
#else
    vec3 emitted = uEmitted;
    if (uHasEmissiveTexture) emitted *= texture(uEmissiveTexture, vEmissiveTexcoord).rgb;
    vec3 radiance = (uShow == SHOW_IRRADIANCE ? vec3(1.0) : base.rgb) * irradiance / PI + (uShow == SHOW_IRRADIANCE ? vec3(0.0) : emitted);
    vec3 color = displayed(radiance);
    if (!has_texels && max(max(emitted.r, emitted.g), emitted.b) == 0.0) color = vec3(0.16, 0.19, 0.24);  // mirrors, glass
    else if (uShow == SHOW_NORMALS) color = 0.5 + 0.5 * n;
    else if (has_texels && uShow == SHOW_TEXELS) color = texelColor() * (0.35 + 0.65 * displayed(irradiance / PI));
    else if (has_texels && uShow == SHOW_HITS) color = hitsColor();
    else if (has_texels && uShow == SHOW_CLAMPED) {
        float lost = -min(min(series.r, min(series.g, series.b)), 0.0), whole = max(series.r, max(series.g, series.b));
        color = mix(vec3(dot(color, vec3(0.3, 0.6, 0.1))), vec3(1.0, 0.1, 0.1), lost > 0.0 ? 0.4 + 0.6 * min(lost / max(whole, lost), 1.0) : 0.0);
    } else if (has_texels && uShow == SHOW_FILTERS) {
        vec3 a = max(exactSeries(n, geometric), 0.0), b = max(hardwareSeries(n, smooth_normal), 0.0);
        color = scaleColor(length(a - b) / max(length(a), 1e-6) / 0.2);
    }
    oColor = vec4(color, 1.0);
#endif
}
#endif
