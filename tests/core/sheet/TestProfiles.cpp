#include "TestProfiles.h"

#include <algorithm>
#include <cmath>
#include <lcms2.h>

namespace dipwright {
namespace {

QByteArray saved(cmsHPROFILE profile) {
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    QByteArray bytes(qsizetype(size), '\0');
    cmsSaveProfileToMem(profile, bytes.data(), &size);
    cmsCloseProfile(profile);
    return bytes;
}

// sRGB's primaries adapted to D50, rows X, Y, Z.
constexpr double toXyz[3][3] = {{0.4360747, 0.3850649, 0.1430804},
                                {0.2225045, 0.7168786, 0.0606169},
                                {0.0139322, 0.0971045, 0.7141733}};
constexpr double toRgb[3][3] = {{3.1338561, -1.6168667, -0.4906146},
                                {-0.9787684, 1.9161415, 0.0334540},
                                {0.0719453, -0.2289914, 1.4052427}};

cmsInt32Number inkToLab(const cmsUInt16Number in[], cmsUInt16Number out[], void* context) {
    const double least = *static_cast<double*>(context);
    double light[3];
    for (int i = 0; i < 3; ++i) {
        light[i] = least + (1 - least) * (1 - in[i] / 65535.0) * (1 - in[3] / 65535.0);
    }
    cmsCIEXYZ xyz{};
    double* components[3] = {&xyz.X, &xyz.Y, &xyz.Z};
    for (int row = 0; row < 3; ++row) {
        for (int i = 0; i < 3; ++i) {
            *components[row] += toXyz[row][i] * light[i];
        }
    }
    cmsCIELab lab;
    cmsXYZ2Lab(nullptr, &lab, &xyz);
    cmsFloat2LabEncoded(out, &lab);
    return 1;
}

cmsInt32Number labToInk(const cmsUInt16Number in[], cmsUInt16Number out[], void* context) {
    const double least = *static_cast<double*>(context);
    cmsCIELab lab;
    cmsLabEncoded2Float(&lab, in);
    cmsCIEXYZ xyz;
    cmsLab2XYZ(nullptr, &xyz, &lab);
    const double components[3] = {xyz.X, xyz.Y, xyz.Z};
    for (int row = 0; row < 3; ++row) {
        double light = 0;
        for (int i = 0; i < 3; ++i) {
            light += toRgb[row][i] * components[i];
        }
        const double ink = 1 - (light - least) / (1 - least);
        out[row] = cmsUInt16Number(std::lround(65535 * std::clamp(ink, 0.0, 1.0)));
    }
    out[3] = 0;
    return 1;
}

void setTable(cmsHPROFILE profile, cmsTagSignature tag, int from, int to, cmsSAMPLER16 sampler,
              double leastLight) {
    cmsPipeline* pipeline = cmsPipelineAlloc(nullptr, cmsUInt32Number(from), cmsUInt32Number(to));
    cmsStage* table = cmsStageAllocCLut16bit(nullptr, from == 3 ? 33 : 9, cmsUInt32Number(from),
                                             cmsUInt32Number(to), nullptr);
    cmsStageSampleCLut16bit(table, sampler, &leastLight, 0);
    // The file format allows a table only between curves.
    cmsPipelineInsertStage(pipeline, cmsAT_END,
                           cmsStageAllocToneCurves(nullptr, cmsUInt32Number(from), nullptr));
    cmsPipelineInsertStage(pipeline, cmsAT_END, table);
    cmsPipelineInsertStage(pipeline, cmsAT_END,
                           cmsStageAllocToneCurves(nullptr, cmsUInt32Number(to), nullptr));
    cmsWriteTag(profile, tag, pipeline);
    cmsPipelineFree(pipeline);
}

void setDescription(cmsHPROFILE profile, const char* words) {
    cmsMLU* text = cmsMLUalloc(nullptr, 1);
    cmsMLUsetASCII(text, "en", "US", words);
    cmsWriteTag(profile, cmsSigProfileDescriptionTag, text);
    cmsMLUfree(text);
}

} // namespace

QByteArray paleRgbProfile() {
    const cmsCIExyY white{0.3127, 0.3290, 1};
    const auto pale = [&](double x, double y) {
        return cmsCIExyY{(x + white.x) / 2, (y + white.y) / 2, 1};
    };
    const cmsCIExyYTRIPLE primaries{pale(0.64, 0.33), pale(0.30, 0.60), pale(0.15, 0.06)};
    cmsToneCurve* curve = cmsBuildGamma(nullptr, 2.2);
    cmsToneCurve* curves[3] = {curve, curve, curve};
    cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves);
    cmsFreeToneCurve(curve);
    cmsSetDeviceClass(profile, cmsSigOutputClass);
    setDescription(profile, "Pale printer");
    return saved(profile);
}

QByteArray simpleCmykProfile(double leastLight) {
    cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
    cmsSetProfileVersion(profile, 4.3);
    cmsSetDeviceClass(profile, cmsSigOutputClass);
    cmsSetColorSpace(profile, cmsSigCmykData);
    cmsSetPCS(profile, cmsSigLabData);
    setTable(profile, cmsSigAToB0Tag, 4, 3, inkToLab, leastLight);
    setTable(profile, cmsSigBToA0Tag, 3, 4, labToInk, leastLight);
    setDescription(profile, "Simple inks");
    return saved(profile);
}

} // namespace dipwright
