#include "pipeline/InkOptions.h"

#include "base/NumberText.h"
#include "base/WideGamut.h"
#include "parallel/ParallelFor.h"
#include "sheet/prepress/PlateCompensation.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "texture/ContrastKept.h"
#include "texture/Ink.h"
#include "texture/ReverseTexture.h"
#include "texture/StretchPlane.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(InkOptions)
};

constexpr double mostSamples = 1e6;  // of each film
constexpr double leftShort = 0.05;   // of the short area that lightening may leave
constexpr double leastDensest = 0.5; // darker colours would hardly show
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
    LinearColour light; // in sRGB's primaries
};

// The part below the ink, in light of sRGB's primaries.
struct Beneath {
    LinearColour base = LinearColour::Ones();
    float white = 0; // wanted tint of the white layer

    LinearColour light(const InkCompensation& ink, float stretch) const {
        const float hidden =
            white > 0 ? ink.shownWhite(ink.printWhite(white, stretch), stretch) : 0;
        return base * (1 - hidden) + hidden;
    }
};

Beneath beneathOf(const Project& project, bool withWhite) {
    Beneath beneath;
    if (!project.baseColour.isEmpty()) {
        beneath.base = linearColour(QColor(project.baseColour));
    }
    beneath.white = withWhite ? float(project.sheet.whiteDensity) : 0;
    return beneath;
}

// How ink with some settings looks on the body.
class InkOnBody {
public:
    virtual ~InkOnBody() = default;
    virtual std::vector<Shown> shown(const Samples& samples) const = 0;
    // Returns how the texture looks if no film stretches, in light of sRGB's primaries.
    virtual std::vector<LinearColour> reference(const Samples& samples) const = 0;
};

// Ink compensated in the picture, before any separation.
class PictureInk : public InkOnBody {
public:
    PictureInk(const InkSettings& settings, const Beneath& beneath)
        : ink_(settings), beneath_(beneath), darkest_(std::pow(10.0f, -float(settings.limit))) {}

    std::vector<Shown> shown(const Samples& samples) const override {
        std::vector<Shown> all(samples.places.size());
        parallelFor(std::size_t(0), all.size(), [&](std::size_t i) {
            const Sample& sample = samples.places[i];
            const LinearColour wanted = ink_.toned(sample.texture);
            // No pass can print more than the ink limit.
            const LinearColour printed = ink_.print(wanted, sample.stretch).colour.max(darkest_);
            const LinearColour through = ink_.shown(printed, sample.stretch);
            for (int channel = 0; channel < lightInks; ++channel) {
                all[i].missing =
                    std::max(all[i].missing, densityOf(std::max(wanted[channel], darkest_)) -
                                                 densityOf(through[channel]));
            }
            all[i].light = (samples.isWide ? srgbLight(through) : through) *
                           beneath_.light(ink_, sample.stretch);
        });
        return all;
    }
    std::vector<LinearColour> reference(const Samples& samples) const override {
        std::vector<LinearColour> all;
        for (const Sample& sample : samples.places) {
            all.push_back(samples.isWide ? srgbLight(sample.texture) : sample.texture);
        }
        return all;
    }

private:
    InkCompensation ink_;
    Beneath beneath_;
    float darkest_; // linear light at the ink limit
};

// Each ink of a printer compensated by itself, within its total area coverage.
class PlateInk : public InkOnBody {
public:
    PlateInk(const InkSettings& settings, const Beneath& beneath, const PrintCorrection& printer)
        : ink_(settings), beneath_(beneath), law_(*printer.colour, settings), printer_(printer) {
        for (int ink = 0; ink < 4; ++ink) {
            densities_[std::size_t(ink)] = printer.colour->inkDensities(ink);
        }
    }

    std::vector<Shown> shown(const Samples& samples) const override {
        const QByteArray wanted = inksOf(samples, true);
        QByteArray inks = wanted;
        auto* const bytes = reinterpret_cast<uchar*>(inks.data());
        const auto* const asked = reinterpret_cast<const uchar*>(wanted.constData());
        const auto forInks = [&](const auto& work) {
            parallelFor(std::size_t(0), 4 * samples.places.size(),
                        [&](std::size_t i) { work(i, int(i % 4), samples.places[i / 4].stretch); });
        };
        forInks([&](std::size_t i, int ink, float stretch) {
            bytes[i] = law_.printed(ink, asked[i], stretch);
        });
        if (printer_.totalInk) {
            limitInk(inks, *printer_.totalInk);
        }
        std::vector<float> missing(4 * samples.places.size());
        forInks([&](std::size_t i, int ink, float stretch) {
            const double left = law_.shown(ink, bytes[i], stretch);
            missing[i] = density(ink, asked[i]) - density(ink, left);
            bytes[i] = uchar(std::lround(left));
        });
        const std::vector<LinearColour> lights = lightsOf(inks, samples.places.size());
        std::vector<Shown> all(samples.places.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].missing = *std::max_element(missing.begin() + std::ptrdiff_t(4 * i),
                                               missing.begin() + std::ptrdiff_t(4 * i + 4));
            all[i].light = lights[i] * beneath_.light(ink_, samples.places[i].stretch);
        }
        return all;
    }
    std::vector<LinearColour> reference(const Samples& samples) const override {
        return lightsOf(inksOf(samples, false), samples.places.size());
    }

private:
    static constexpr int width = 1024; // of the pictures that hold the samples

    static QSize sizeFor(std::size_t samples) {
        return {width, int((samples + width - 1) / width)};
    }
    // Returns the inks of the texture, lightened by the tone curve or not.
    QByteArray inksOf(const Samples& samples, bool isToned) const {
        QImage picture(sizeFor(samples.places.size()),
                       samples.isWide ? QImage::Format_RGBA64 : QImage::Format_RGBA8888);
        picture.fill(Qt::white);
        if (samples.isWide) {
            picture.setColorSpace(wideSpace());
        }
        const PixelCode code(picture);
        uchar* const bits = picture.bits();
        const qsizetype stride = picture.bytesPerLine();
        parallelFor(std::size_t(0), samples.places.size(), [&](std::size_t i) {
            const LinearColour& texture = samples.places[i].texture;
            code.write(bits + qsizetype(i / width) * stride + qsizetype(i % width) * code.bytes(),
                       isToned ? ink_.toned(texture) : texture, code.opaque());
        });
        return printer_.colour->cmyk(onWhitePaper(picture));
    }
    std::vector<LinearColour> lightsOf(const QByteArray& inks, std::size_t samples) const {
        const QImage print = printer_.colour->screen(inks, sizeFor(samples));
        std::vector<LinearColour> lights(samples);
        for (std::size_t i = 0; i < samples; ++i) {
            const uchar* pixel = print.constScanLine(int(i / width)) + 3 * (i % width);
            for (int channel = 0; channel < 3; ++channel) {
                lights[i][channel] = linearTable()[pixel[channel]];
            }
        }
        return lights;
    }
    float density(int ink, double amount) const {
        const std::array<float, 256>& own = densities_[std::size_t(ink)];
        const int below = std::clamp(int(amount), 0, 254);
        return own[std::size_t(below)] +
               float(amount - below) * (own[std::size_t(below) + 1] - own[std::size_t(below)]);
    }

    InkCompensation ink_;
    Beneath beneath_;
    PlateCompensation law_;
    PrintCorrection printer_;
    std::array<std::array<float, 256>, 4> densities_;
};

// The samples and where ink is short now.
class Places {
public:
    Places(Samples samples, const InkOnBody& now)
        : samples_(std::move(samples)), reference_(now.reference(samples_)) {
        const std::vector<Shown> shown = now.shown(samples_);
        short_.isWide = samples_.isWide;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const Sample& sample = samples_.places[i];
            area_ += double(sample.area);
            isShort_.push_back(shown[i].missing > visibleDensity);
            if (isShort_.back()) {
                short_.places.push_back(sample);
                shortArea_ += double(sample.area);
            }
        }
    }

    double area() const { return area_; }
    double shortArea() const { return shortArea_; }

    InkReach reach(const InkOnBody& ink) const {
        const std::vector<Shown> shown = ink.shown(samples_);
        InkReach reach;
        std::vector<float> where;
        ContrastKept contrast;
        double shortNow = 0, error = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const auto area = double(samples_.places[i].area);
            const Eigen::Array3f asked = labOf(reference_[i]), lab = labOf(shown[i].light);
            shortNow += shown[i].missing > visibleDensity ? area : 0;
            error += area * double((asked - lab).matrix().norm());
            reach.mostMissing = std::max(reach.mostMissing, double(shown[i].missing));
            if (isShort_[i]) {
                where.push_back(shown[i].missing);
                contrast.add(double(asked[0]), double(lab[0]), area);
            }
        }
        reach.shortShare = area_ > 0 ? shortNow / area_ : 0;
        reach.colourError = area_ > 0 ? error / area_ : 0;
        if (!where.empty()) {
            const auto rank = where.begin() + std::ptrdiff_t(0.95 * double(where.size() - 1));
            std::nth_element(where.begin(), rank, where.end());
            reach.missing95 = std::max(0.0, double(*rank));
        }
        reach.contrast = contrast.share();
        return reach;
    }

    // Returns the area that stays short, of the area that is short now.
    double leftArea(const InkOnBody& ink) const {
        const std::vector<Shown> shown = ink.shown(short_);
        double left = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            left += shown[i].missing > visibleDensity ? double(short_.places[i].area) : 0;
        }
        return left;
    }

    // Returns the stretch up to which `ink` suffices on 95 % of the samples that are short now.
    double usableStretch(const InkOnBody& ink) const {
        Samples tried{{}, short_.isWide};
        const std::size_t stride =
            std::max<std::size_t>(1, short_.places.size() / mostStretchSamples);
        std::vector<float> low, high;
        for (std::size_t i = 0; i < short_.places.size(); i += stride) {
            tried.places.push_back(short_.places[i]);
            low.push_back(1);
            high.push_back(std::max(short_.places[i].stretch, 1.0f));
        }
        for (int step = 0; step < 12; ++step) {
            for (std::size_t i = 0; i < low.size(); ++i) {
                tried.places[i].stretch = (low[i] + high[i]) / 2;
            }
            const std::vector<Shown> shown = ink.shown(tried);
            for (std::size_t i = 0; i < low.size(); ++i) {
                (shown[i].missing > visibleDensity ? high : low)[i] = tried.places[i].stretch;
            }
        }
        const auto rank = low.begin() + std::ptrdiff_t(low.size() / 20);
        std::nth_element(low.begin(), rank, low.end());
        return double(*rank);
    }

private:
    Samples samples_, short_; // all, and those where ink is short now
    std::vector<LinearColour> reference_;
    std::vector<bool> isShort_;
    double area_ = 0, shortArea_ = 0;
};

// Makes the ink of some settings, with white beneath or not.
using InkMaker = std::function<std::unique_ptr<InkOnBody>(const InkSettings&, bool withWhite)>;

// Returns the largest density to which the texture can be lightened so that hardly any area stays
// short, at least leastDensest; none if the texture is lightened as far already.
std::optional<double>
densestFor(const Places& places, const InkSettings& ink,
           const std::function<std::unique_ptr<InkOnBody>(const InkSettings&)>& inkOf) {
    const auto densestAt = [most = std::min(ink.densest, ink.limit)](int step) {
        return std::round(most / densestStep - step) * densestStep;
    };
    const auto suffices = [&](int step) {
        InkSettings lighter = ink;
        lighter.densest = densestAt(step);
        return places.leftArea(*inkOf(lighter)) <= leftShort * places.shortArea();
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

// Returns the options in the order of InkRemedy; none if ink suffices.
std::optional<InkOptions> comparedOptions(const Project& project, Samples samples,
                                          const InkMaker& inkOf, const Progress& progress) {
    const QString text = Text::tr("Comparing the options for ink");
    const bool hasWhite = project.sheet.white != WhiteLayer::None;
    const auto sameWhite = [&](const InkSettings& settings) { return inkOf(settings, hasWhite); };
    const auto now = sameWhite(project.ink);
    const Places places(std::move(samples), *now);
    if (places.shortArea() < leastShortArea) {
        return std::nullopt;
    }
    InkOptions found{places.area(), places.reach(*now), {}};
    progress(0.2, text);
    if (const auto densest = densestFor(places, project.ink, sameWhite)) {
        InkSettings lighter = project.ink;
        lighter.densest = *densest;
        found.options.push_back(
            {InkRemedy::LighterTexture, *densest, places.reach(*sameWhite(lighter))});
    }
    progress(0.6, text);
    if (!hasWhite) {
        found.options.push_back(
            {InkRemedy::WhiteBeneath, 1, places.reach(*inkOf(project.ink, true))});
    }
    if (project.ink.passes < mostInkPasses) {
        InkSettings more = project.ink;
        ++more.passes;
        found.options.push_back(
            {InkRemedy::SecondPass, double(more.passes), places.reach(*sameWhite(more))});
    }
    found.options.push_back({InkRemedy::OtherPose, places.usableStretch(*now), std::nullopt});
    progress(1, text);
    return found;
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
    bool isPerInk = false;
    for (const ImmersionResult& dip : result.immersions) {
        // Options are computed from colours, but amounts of ink are printed without them.
        if (!dip.inputs.texture.isReversed() || !dip.texture || !dip.texture->inks.isNull()) {
            return std::nullopt;
        }
        reported += dip.inkShortfall.value_or(dip.texture->shortfallArea);
        isPerInk = isPerInk || dip.inkShortfall;
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
    std::optional<PrinterColour> colour;
    PrintCorrection correction;
    if (const auto& printer = project.profiles.printer; isPerInk && printer) {
        colour.emplace(*printer, printer->name);
        correction.colour = &*colour;
        correction.totalInk = printer->totalInk;
    }
    const InkMaker inkOf = [&](const InkSettings& settings,
                               bool withWhite) -> std::unique_ptr<InkOnBody> {
        const Beneath beneath = beneathOf(project, withWhite);
        if (correction.colour) {
            return std::make_unique<PlateInk>(settings, beneath, correction);
        }
        return std::make_unique<PictureInk>(settings, beneath);
    };
    return comparedOptions(project, std::move(samples), inkOf, progress.part(0.4, 1));
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
        return Text::tr("Lighten the darkest colours to density %1")
            .arg(numberText(option.value, 2));
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
                       .arg(numberText(100 * reach.shortShare, 2), numberText(reach.missing95, 2),
                            numberText(reach.mostMissing, 2), numberText(reach.colourError, 1));
    if (!std::isnan(reach.contrast)) {
        text += Text::tr("; %1 % of the contrast there").arg(numberText(100 * reach.contrast, 0));
    }
    return text;
}

QString optionText(const InkOption& option) {
    return option.reach ? reachText(*option.reach)
                        : Text::tr("ink suffices where the area of the film grows at most %1 times")
                              .arg(numberText(option.value, 2));
}

} // namespace dipwright
