#include "cli/PackOptions.h"

#include "cli/Arguments.h"
#include "project/FilmSizes.h"

#include <QRegularExpression>

#include <algorithm>

namespace dipwright::cli {
namespace {

const QString filmOption = QStringLiteral("film");
const QString spacingOption = QStringLiteral("spacing");
const QString marginOption = QStringLiteral("margin");
const QString feedOption = QStringLiteral("feed");
const QString turnOption = QStringLiteral("turn");
const QString wholeOption = QStringLiteral("whole");

// Reads the film: the name of a size, WIDTHxHEIGHT, roll:WIDTH or roll:WIDTHxLENGTH.
void setFilm(PackingFilm& film, const QString& text) {
    static const QRegularExpression sizes(
        QStringLiteral("^(roll:)?(\\d+(?:\\.\\d+)?)(?:x(\\d+(?:\\.\\d+)?))?$"));
    const QRegularExpressionMatch match = sizes.match(text);
    film.isRoll = !match.captured(1).isEmpty();
    if (filmSizeNames().contains(text)) {
        film.size = filmSize(text);
        return;
    }
    const bool hasLength = !match.captured(3).isEmpty();
    film.size = {match.captured(2).toDouble(),
                 hasLength ? match.captured(3).toDouble() : mostFilmLength};
    constexpr double least = 50;
    if (!match.hasMatch() || !(hasLength || film.isRoll) ||
        std::min(film.size.width(), film.size.height()) < least ||
        std::max(film.size.width(), film.size.height()) > mostFilmLength) {
        throw UsageError(QStringLiteral("Write the film as %1, WIDTHxHEIGHT, roll:WIDTH or "
                                        "roll:WIDTHxLENGTH in mm, %2 to %3")
                             .arg(filmSizeNames().join(QStringLiteral(", ")))
                             .arg(least)
                             .arg(mostFilmLength),
                         QStringLiteral("--film"));
    }
}

} // namespace

PackSettings packSettings(const QCommandLineParser& parser) {
    PackSettings settings;
    if (parser.isSet(filmOption)) {
        setFilm(settings.film, parser.value(filmOption));
    }
    if (parser.isSet(spacingOption)) {
        settings.film.spacing = Millimetres(numberOption(parser, spacingOption, 0, 200));
    }
    if (parser.isSet(marginOption)) {
        settings.film.margin =
            Millimetres(numberOption(parser, marginOption, leastPieceMargin, 200));
    }
    const QString feed = parser.value(feedOption);
    if (!feed.isEmpty() && feed != QLatin1String("short") && feed != QLatin1String("long")) {
        throw UsageError(
            QStringLiteral("Give the edge that enters the printer first, short or long"),
            QStringLiteral("--feed"));
    }
    settings.feed = feed == QLatin1String("long") ? FeedDirection::LongEdgeFirst
                                                  : FeedDirection::ShortEdgeFirst;
    settings.mayTurn = parser.isSet(turnOption);
    settings.film.wholeSheets = parser.isSet(wholeOption);
    return settings;
}

void refusePackingWithoutFilm(const QCommandLineParser& parser) {
    if (!packs(parser)) {
        refuseOptions(parser, {spacingOption, marginOption, wholeOption, feedOption, turnOption},
                      QStringLiteral("without --film"));
    }
}

bool packs(const QCommandLineParser& parser) {
    return parser.isSet(filmOption);
}

void declarePacking(CommandSyntax& syntax, const QString& withoutFilm) {
    const auto value = [&](const QString& name, const char* words, const char* kind) {
        syntax.addOption({name, QString::fromUtf8(words), QString::fromLatin1(kind)});
    };
    syntax.addOption(
        {filmOption,
         QStringLiteral("The film: the name of a size, WIDTHxHEIGHT, or a roll as roll:WIDTH or "
                        "roll:WIDTHxLENGTH, in mm. A roll is cut off after the last piece. ") +
             withoutFilm,
         QStringLiteral("SIZE")});
    value(spacingOption, "The distance between two pieces in mm, 0 to 200; default 3.", "MM");
    value(marginOption, "The bare film around the ink in mm, 7 to 200; default 7.", "MM");
    syntax.addOption(
        {wholeOption, QStringLiteral("Places whole sheets with their own marks, and cut marks in "
                                     "the gaps between them, as a series on a roll.")});
    value(feedOption, "The edge of the film that enters the printer first.", "short|long");
    syntax.addOption({turnOption, QStringLiteral("Turns pieces by 90° to save film, if their "
                                                 "film swells equally in both directions.")});
}

} // namespace dipwright::cli
