#include "pipeline/JobSheet.h"

#include "base/Error.h"
#include "base/Sha256.h"
#include "pipeline/StepInputs.h"
#include "project/Project.h"
#include "settings/Immersion.h"
#include "sheet/page/PaperMargins.h"
#include "sheet/page/SheetLayout.h"
#include "sheet/prepress/Separation.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr int hashLetters = 12; // 48 bits: distinguishes sheets and is easy to compare

QString plain(double number) {
    return QString::number(number, 'g', 6);
}

QString filmText(const FilmSettings& film) {
    const QString size =
        Text::tr("%1 × %2 mm").arg(plain(film.width.value()), plain(film.height.value()));
    return film.preset == QLatin1String("custom") ? size
                                                  : QStringLiteral("%1 %2").arg(film.preset, size);
}

QString scaleText(const FilmSettings& film) {
    if (film.swellX == 1 && film.swellY == 1) {
        return QStringLiteral("1:1");
    }
    return Text::tr("1:1, reduced for swell %1 × %2").arg(plain(film.swellX), plain(film.swellY));
}

void addPixels(Sha256& hash, const QImage& image) {
    for (int row = 0; row < image.height(); ++row) {
        const auto* line = reinterpret_cast<const char*>(image.constScanLine(row));
        hash.add(QByteArrayView(line, qsizetype(image.width()) * image.depth() / 8));
    }
}

// Returns a hash of the film's pictures and of all their settings. Neither the project's location
// nor the solver's name has an effect: another solver's pictures differ anyway.
QString jobHash(const Project& project, const Immersion& immersion, const PrintedFilm& film) {
    Project anonymous = project;
    anonymous.process.solver = ProcessSettings().solver;
    anonymous.baseColour.clear(); // this colour is not printed
    anonymous.profiles = withoutCosts(project.profiles);
    anonymous.profiles.printer.reset(); // numberedFor() in PrintFile.h adds its digits
    QJsonObject settings = countedSettings(anonymous);
    for (const char* key : {"model", "immersions", "name", "cradle", "tolerance", "verdict",
                            "inspection", "pose_search", "order", "as_built"}) {
        settings.remove(QLatin1String(key));
    }
    if (!isShared(project)) {
        settings.remove(QStringLiteral("share"));
    }
    settings.insert(QStringLiteral("rotation"),
                    QJsonArray{immersion.rotation[0].value(), immersion.rotation[1].value(),
                               immersion.rotation[2].value()});
    settings.insert(QStringLiteral("offset"),
                    QJsonArray{immersion.offset[0].value(), immersion.offset[1].value()});
    if (!immersion.path.isStraightDown()) {
        settings.insert(QStringLiteral("path"), pathToJson(immersion));
    }
    Sha256 hash;
    hash.add(QJsonDocument(settings).toJson(QJsonDocument::Compact));
    addPixels(hash, film.colours);
    hash.add(film.inks.space.toLatin1());
    for (const QImage& image :
         {film.white, film.wanted, film.stretch, film.inks.colours, film.inks.black}) {
        addPixels(hash, image); // the image may be null
    }
    for (const QImage& tints : film.spots) {
        addPixels(hash, tints);
    }
    return QString::fromLatin1(hash.result().toHex().left(hashLetters));
}

} // namespace

void checkSpots(const Project& project) {
    const SheetSettings& sheet = project.sheet;
    const bool hasWhite = sheet.white != WhiteLayer::None;
    const bool hasCut = sheet.cutLine != CutLine::None;
    const auto areSame = [](const QString& a, const QString& b) {
        return a.compare(b, Qt::CaseInsensitive) == 0;
    };
    if (hasWhite && hasCut && areSame(sheet.whiteName, sheet.cutName)) {
        throw Error(Text::tr("The white ink and the cut contour are both named %1; rename one of "
                             "them under Sheet, Spot colours")
                        .arg(sheet.whiteName),
                    QStringLiteral("sheet.cut_name"));
    }
    const std::vector<ArtworkLayer> spots = project.artwork.spots();
    for (auto layer = spots.begin(); layer != spots.end(); ++layer) {
        if (hasWhite && areSame(layer->spot, sheet.whiteName)) {
            throw Error(Text::tr("The layer's spot colour has the name of the sheet's white ink, "
                                 "%1; give the layer another spot colour, or rename the white ink "
                                 "under Sheet, Spot colours")
                            .arg(sheet.whiteName),
                        layer->name);
        }
        if (hasCut && areSame(layer->spot, sheet.cutName)) {
            throw Error(Text::tr("The layer's spot colour has the name of the cut contour, %1; "
                                 "give the layer another spot colour, or rename the cut contour "
                                 "under Sheet, Spot colours")
                            .arg(sheet.cutName),
                        layer->name);
        }
        const auto other = std::find_if(spots.begin(), layer, [&](const ArtworkLayer& known) {
            return areSame(known.spot, layer->spot);
        });
        if (other != layer) {
            throw Error(Text::tr("The spot colours %1 and %2 differ only in capital letters; write "
                                 "both alike, or give the layer another spot colour")
                            .arg(other->spot, layer->spot),
                        layer->name);
        }
    }
    if (spots.size() > mostSpots) {
        throw Error(
            Text::tr("The artwork has %1 spot colours, more than the limit of %2; remove some")
                .arg(spots.size())
                .arg(mostSpots),
            QStringLiteral("artwork"));
    }
}

void checkEditedSpots(const Project& before, const Project& after) {
    try {
        checkSpots(before);
    } catch (const Error&) {
        return;
    }
    checkSpots(after);
}

Millimetres markClearance(const Project& project) {
    const auto& printer = project.profiles.printer;
    const Sheet bare{{}, project.film.width, project.film.height, project.sheet, {}};
    return clearanceFor(paperSize(bare), unreachable({}, printer),
                        printCorrection(printer, nullptr));
}

Sheet jobSheet(const Project& project, const Immersion& immersion, const PrintedFilm& film,
               const CancelToken& user) {
    Sheet sheet;
    sheet.image = film.colours;
    const std::vector<ArtworkLayer> spots = project.artwork.spots();
    for (std::size_t spot = 0; spot < film.spots.size(); ++spot) {
        const ArtworkLayer& layer = spots[spot];
        sheet.plates.push_back({layer.spot, film.spots[spot], layer.spotFirst, layer.spotColour});
    }
    if (!film.white.isNull()) {
        const double pixels = film.white.width() / project.film.width.value(); // pixels per mm
        user.throwIfCancelled();
        sheet.plates.push_back({project.sheet.whiteName,
                                choked(film.white, project.sheet.whiteChoke.value() * pixels),
                                project.sheet.white == WhiteLayer::First});
    }
    if (!film.wanted.isNull()) {
        sheet.wanted = WantedInk{film.wanted, film.stretch, project.ink, film.inks};
    }
    user.throwIfCancelled();
    sheet.filmWidth = project.film.width;
    sheet.filmHeight = project.film.height;
    sheet.settings = project.sheet;
    sheet.clearance = markClearance(project);
    sheet.job = {
        project.name,           immersion.name,          project.date,
        filmText(project.film), scaleText(project.film), jobHash(project, immersion, film)};
    return sheet;
}

} // namespace dipwright
