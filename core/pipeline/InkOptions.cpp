#include "pipeline/InkOptions.h"

#include "parallel/ParallelFor.h"
#include "texture/Ink.h"
#include "texture/ReverseTexture.h"
#include "texture/StretchPlane.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(InkOptions)
};

constexpr double mostSamples = 1e6;     // of each film
constexpr float visibleDensity = 0.05f; // as in texture/Ink.cpp
constexpr double leftShort = 0.05;      // of the short area that lightening may leave
constexpr double leastDensest = 0.5;    // darker colours would hardly show
constexpr double densestStep = 0.05;
constexpr double poseStretchWeight = 1;
constexpr std::size_t mostStretchSamples = 2000;

// A place of the painted film.
struct Sample {
    LinearColour texture; // the colour that the texture has there
    float stretch = 1;    // growth of the film's area
    float area = 0;       // mm² of the body
};

struct Samples {
    std::vector<Sample> places;
    bool isWide = false;
};

float densityOf(float light) {
    return -std::log10(std::max(light, 1e-12f));
}

// Returns the texture and the stretch of one dip's film, at a reduced resolution.
void addSamples(Samples& samples, const JobResult& result, std::size_t dip,
                const BodyColours& colours, const Progress& progress) {
    const ImmersionResult& immersion = result.immersions[dip];
    const FilmSettings& film = result.project.film;
    const double width = film.width.value(), height = film.height.value();
    const double perMillimetre =
        std::min(std::sqrt(mostSamples / (width * height)), immersion.sheet.image.width() / width);
    ReverseTextureOptions options;
    options.pixels = {int(std::ceil(width * perMillimetre)),
                      int(std::ceil(height * perMillimetre))};
    options.bleed = 0;
    options.ink = result.project.ink;
    options.ink.densest = leastLightening;
    options.ink.passes = 1;
    if (result.share) {
        options.share = result.share->of(dip);
    }
    options.mask = result.mask;
    options.tolerance = 1 / perMillimetre;
    options.returnsWanted = true;
    const ReverseTexture texture = reverseTexture(*immersion.laid, colours, options, progress);
    const PixelCode code(texture.wanted);
    samples.isWide = code.isWide();
    const double pixelArea =
        width * height / (double(options.pixels.width()) * options.pixels.height());
    for (int y = 0; y < options.pixels.height(); ++y) {
        const uchar* pixel = texture.wanted.constScanLine(y);
        const auto* codes =
            reinterpret_cast<const std::uint16_t*>(texture.stretch.constScanLine(y));
        for (int x = 0; x < options.pixels.width(); ++x, pixel += code.bytes()) {
            if (code.alpha(pixel) != 0) {
                const float stretch = areaStretchOf(codes[x]);
                samples.places.push_back({code.light(pixel), stretch, float(pixelArea) * stretch});
            }
        }
    }
}

// What the body shows at a sample.
struct Shown {
    float missing = 0;  // density
    LinearColour light; // in the samples' primaries
};

// The part below the ink.
struct Beneath {
    LinearColour base = LinearColour::Ones();
    float white = 0; // wanted tint of the white layer
};

Beneath beneathOf(const Project& project, bool withWhite, bool isWide) {
    Beneath beneath;
    if (!project.baseColour.isEmpty()) {
        const LinearColour base = linearColour(QColor(project.baseColour));
        beneath.base = isWide ? wideLight(base) : base;
    }
    beneath.white = withWhite ? float(project.sheet.whiteDensity) : 0;
    return beneath;
}

class InkOnBody {
public:
    InkOnBody(const InkSettings& settings, const Beneath& beneath)
        : ink_(settings), beneath_(beneath), darkest_(std::pow(10.0f, -float(settings.limit))) {}

    Shown at(const Sample& sample) const {
        const LinearColour wanted = ink_.toned(sample.texture);
        // No pass can print more than the ink limit.
        const LinearColour printed = ink_.print(wanted, sample.stretch).colour.max(darkest_);
        const LinearColour through = ink_.shown(printed, sample.stretch);
        Shown shown;
        for (int channel = 0; channel < lightInks; ++channel) {
            shown.missing = std::max(shown.missing, densityOf(std::max(wanted[channel], darkest_)) -
                                                        densityOf(through[channel]));
        }
        shown.light = through * ground(sample.stretch);
        return shown;
    }

private:
    LinearColour ground(float stretch) const {
        const float hidden =
            beneath_.white > 0 ? ink_.shownWhite(ink_.printWhite(beneath_.white, stretch), stretch)
                               : 0;
        return beneath_.base * (1 - hidden) + hidden;
    }

    InkCompensation ink_;
    Beneath beneath_;
    float darkest_; // linear light at the ink limit
};

// CIE L*a*b* of light in sRGB's primaries, relative to D65.
Eigen::Array3f labOf(const LinearColour& light) {
    const auto root = [](float value) {
        return value > 0.008856f ? std::cbrt(value) : 7.787f * value + 16.0f / 116;
    };
    const float x =
        (0.4124564f * light[0] + 0.3575761f * light[1] + 0.1804375f * light[2]) / 0.95047f;
    const float y = 0.2126729f * light[0] + 0.7151522f * light[1] + 0.0721750f * light[2];
    const float z =
        (0.0193339f * light[0] + 0.1191920f * light[1] + 0.9503041f * light[2]) / 1.08883f;
    return {116 * root(y) - 16, 500 * (root(x) - root(y)), 200 * (root(y) - root(z))};
}

// Weighted mean and variance.
struct Spread {
    double weight = 0, sum = 0, squares = 0;
    void add(double value, double by) {
        weight += by;
        sum += by * value;
        squares += by * value * value;
    }
    double deviation() const {
        const double mean = weight > 0 ? sum / weight : 0;
        return weight > 0 ? std::sqrt(std::max(0.0, squares / weight - mean * mean)) : 0;
    }
};

// The samples and where ink is short now.
class Places {
public:
    Places(Samples samples, const InkOnBody& now)
        : samples_(std::move(samples)), short_(samples_.places.size()) {
        parallelFor(std::size_t(0), short_.size(), [&](std::size_t i) {
            short_[i] = now.at(samples_.places[i]).missing > visibleDensity;
        });
        for (std::size_t i = 0; i < short_.size(); ++i) {
            area_ += double(samples_.places[i].area);
            shortArea_ += short_[i] != 0 ? double(samples_.places[i].area) : 0;
        }
    }

    double area() const { return area_; }
    double shortArea() const { return shortArea_; }

    InkReach reach(const InkOnBody& ink) const {
        std::vector<float> missing(short_.size()), difference(short_.size());
        std::vector<std::array<float, 2>> lightness(short_.size()); // of the texture, shown
        parallelFor(std::size_t(0), short_.size(), [&](std::size_t i) {
            const Sample& sample = samples_.places[i];
            const Shown shown = ink.at(sample);
            const Eigen::Array3f wanted = lab(sample.texture), got = lab(shown.light);
            missing[i] = shown.missing;
            difference[i] = (wanted - got).matrix().norm();
            lightness[i] = {wanted[0], got[0]};
        });
        return summed(missing, difference, lightness);
    }

    // Returns the area that stays short, of the area that is short now.
    double leftArea(const InkOnBody& ink) const {
        std::vector<float> left(short_.size());
        parallelFor(std::size_t(0), short_.size(), [&](std::size_t i) {
            const Sample& sample = samples_.places[i];
            left[i] =
                short_[i] != 0 && ink.at(sample).missing > visibleDensity ? sample.area : 0.0f;
        });
        return std::accumulate(left.begin(), left.end(), 0.0);
    }

    // Returns the stretch up to which `ink` suffices on 95 % of the samples that are short now.
    double usableStretch(const InkOnBody& ink) const {
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < short_.size(); ++i) {
            if (short_[i] != 0) {
                places.push_back(i);
            }
        }
        const std::size_t stride = std::max<std::size_t>(1, places.size() / mostStretchSamples);
        std::vector<float> stretches;
        for (std::size_t i = 0; i < places.size(); i += stride) {
            stretches.push_back(largestStretch(samples_.places[places[i]], ink));
        }
        const auto rank = stretches.begin() + std::ptrdiff_t(stretches.size() / 20);
        std::nth_element(stretches.begin(), rank, stretches.end());
        return double(*rank);
    }

private:
    Eigen::Array3f lab(const LinearColour& light) const {
        return labOf(samples_.isWide ? srgbLight(light) : light);
    }

    static float largestStretch(Sample sample, const InkOnBody& ink) {
        float low = 1, high = std::max(sample.stretch, 1.0f);
        for (int step = 0; step < 12; ++step) {
            sample.stretch = (low + high) / 2;
            (ink.at(sample).missing > visibleDensity ? high : low) = sample.stretch;
        }
        return low;
    }

    InkReach summed(const std::vector<float>& missing, const std::vector<float>& difference,
                    const std::vector<std::array<float, 2>>& lightness) const {
        InkReach reach;
        std::vector<float> where;
        Spread wanted, shown;
        double shortNow = 0, error = 0;
        for (std::size_t i = 0; i < missing.size(); ++i) {
            const auto area = double(samples_.places[i].area);
            shortNow += missing[i] > visibleDensity ? area : 0;
            error += area * double(difference[i]);
            reach.mostMissing = std::max(reach.mostMissing, double(missing[i]));
            if (short_[i] != 0) {
                where.push_back(missing[i]);
                wanted.add(double(lightness[i][0]), area);
                shown.add(double(lightness[i][1]), area);
            }
        }
        reach.shortShare = area_ > 0 ? shortNow / area_ : 0;
        reach.colourError = area_ > 0 ? error / area_ : 0;
        if (!where.empty()) {
            const auto rank = where.begin() + std::ptrdiff_t(0.95 * double(where.size() - 1));
            std::nth_element(where.begin(), rank, where.end());
            reach.missing95 = std::max(0.0, double(*rank));
        }
        const double contrast = wanted.deviation();
        reach.contrast = contrast > 0.5 ? shown.deviation() / contrast
                                        : std::numeric_limits<double>::quiet_NaN();
        return reach;
    }

    Samples samples_;
    std::vector<std::uint8_t> short_;
    double area_ = 0, shortArea_ = 0;
};

// Returns the largest density to which the texture can be lightened so that hardly any area stays
// short, at least leastDensest; none if the texture is lightened as far already.
std::optional<double> densestFor(const Places& places, const InkSettings& ink,
                                 const Beneath& beneath) {
    const auto densestAt = [most = std::min(ink.densest, ink.limit)](int step) {
        return std::round(most / densestStep - step) * densestStep;
    };
    const auto suffices = [&](int step) {
        InkSettings lighter = ink;
        lighter.densest = densestAt(step);
        return places.leftArea(InkOnBody(lighter, beneath)) <= leftShort * places.shortArea();
    };
    int least = 1; // the first step that may suffice
    int most = int((densestAt(0) - leastDensest) / densestStep);
    if (most < 1) {
        return std::nullopt;
    }
    while (least < most) { // the last step is taken even if it leaves more
        const int middle = (least + most) / 2;
        if (suffices(middle)) {
            most = middle;
        } else {
            least = middle + 1;
        }
    }
    return densestAt(most);
}

QString number(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

} // namespace

QString remedyKey(InkRemedy remedy) {
    switch (remedy) {
    case InkRemedy::LighterTexture:
        return QStringLiteral("lighter_texture");
    case InkRemedy::WhiteBeneath:
        return QStringLiteral("white_beneath");
    case InkRemedy::SecondPass:
        return QStringLiteral("another_pass");
    case InkRemedy::OtherPose:
        break;
    }
    return QStringLiteral("other_pose");
}

QString remedyField(InkRemedy remedy) {
    switch (remedy) {
    case InkRemedy::LighterTexture:
        return QStringLiteral("ink.densest");
    case InkRemedy::WhiteBeneath:
        return QStringLiteral("sheet.white");
    case InkRemedy::SecondPass:
        return QStringLiteral("ink.passes");
    case InkRemedy::OtherPose:
        break;
    }
    return {};
}

std::optional<InkOptions> inkOptions(const JobResult& result, const Progress& progress) {
    const Project& project = result.project;
    double reported = 0;
    for (const ImmersionResult& dip : result.immersions) {
        if (!dip.inputs.texture.isReversed() || !dip.texture) {
            return std::nullopt;
        }
        reported += dip.texture->shortfallArea;
    }
    if (reported < leastShortArea || !project.ink.compensate || !result.painted) {
        return std::nullopt;
    }
    const QString text = Text::tr("Comparing the options for ink");
    progress(0, text);
    const auto colours = result.colours ? result.colours : bodyColours(*result.painted);
    Samples samples;
    for (std::size_t dip = 0; dip < result.immersions.size(); ++dip) {
        addSamples(samples, result, dip, *colours, progress.silent());
    }
    progress(0.4, text);
    const bool isWide = samples.isWide;
    const bool hasWhite = project.sheet.white != WhiteLayer::None;
    const Beneath beneath = beneathOf(project, hasWhite, isWide);
    const InkOnBody now(project.ink, beneath);
    const Places places(std::move(samples), now);
    if (places.shortArea() < leastShortArea) {
        return std::nullopt;
    }
    InkOptions found{places.area(), places.reach(now), {}};
    progress(0.5, text);
    if (const auto densest = densestFor(places, project.ink, beneath)) {
        InkSettings lighter = project.ink;
        lighter.densest = *densest;
        found.options.push_back(
            {InkRemedy::LighterTexture, *densest, places.reach(InkOnBody(lighter, beneath))});
    }
    progress(0.8, text);
    if (!hasWhite) {
        found.options.push_back(
            {InkRemedy::WhiteBeneath, 1,
             places.reach(InkOnBody(project.ink, beneathOf(project, true, isWide)))});
    }
    if (project.ink.passes < mostInkPasses) {
        InkSettings more = project.ink;
        ++more.passes;
        found.options.push_back(
            {InkRemedy::SecondPass, double(more.passes), places.reach(InkOnBody(more, beneath))});
    }
    found.options.push_back({InkRemedy::OtherPose, places.usableStretch(now), std::nullopt});
    progress(1, text);
    return found;
}

void take(Project& project, const InkOption& option) {
    switch (option.remedy) {
    case InkRemedy::LighterTexture:
        project.ink.densest = option.value;
        break;
    case InkRemedy::WhiteBeneath:
        project.sheet.white = WhiteLayer::Last;
        break;
    case InkRemedy::SecondPass:
        project.ink.passes = int(option.value);
        break;
    case InkRemedy::OtherPose:
        project.poseAims.weights[Measure::Stretch] =
            std::max(project.poseAims.weights[Measure::Stretch], poseStretchWeight);
        break;
    }
}

QString remedyText(const InkOption& option) {
    switch (option.remedy) {
    case InkRemedy::LighterTexture:
        return Text::tr("Lighten the darkest colours to density %1").arg(number(option.value, 2));
    case InkRemedy::WhiteBeneath:
        return Text::tr("Print white beneath the colours");
    case InkRemedy::SecondPass:
        return Text::tr("Print the ink in %1 passes").arg(int(option.value));
    case InkRemedy::OtherPose:
        break;
    }
    return Text::tr("Search for a pose with less stretch");
}

QString reachText(const InkReach& reach) {
    QString text = Text::tr("%1 % of the painted surface too pale; missing density where it is "
                            "short now: %2 (95 %), %3 at most; mean colour error ΔE %4")
                       .arg(number(100 * reach.shortShare, 2), number(reach.missing95, 2),
                            number(reach.mostMissing, 2), number(reach.colourError, 1));
    if (!std::isnan(reach.contrast)) {
        text += Text::tr("; %1 % of the contrast there").arg(number(100 * reach.contrast, 0));
    }
    return text;
}

QString optionText(const InkOption& option) {
    return option.reach ? reachText(*option.reach)
                        : Text::tr("ink suffices where the area of the film grows at most %1 times")
                              .arg(number(option.value, 2));
}

} // namespace dipwright
