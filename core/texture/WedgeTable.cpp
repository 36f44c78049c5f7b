#include "texture/WedgeTable.h"

#include "base/Error.h"
#include "settings/InkTones.h"

#include <QCoreApplication>
#include <QStringList>
#include <optional>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::WedgeTable)
};

const QByteArray columns = "ink,nominal,flat,across,down,shown";
constexpr double ruler = 100; // mm, length of the page's rulers before the film is stretched
constexpr int mostReadings = 10'000;

std::vector<FilmInk> inksOf(const QString& word) {
    if (word == QLatin1String("grey")) {
        return {FilmInk::Cyan, FilmInk::Magenta, FilmInk::Yellow};
    }
    const std::optional<FilmInk> ink = inkOf(word);
    return ink ? std::vector{*ink} : std::vector<FilmInk>();
}

} // namespace

std::vector<WedgeReading> readWedge(const QByteArray& table, const QString& where) {
    const QStringList lines = QString::fromUtf8(table).split(u'\n');
    if (lines.size() > mostReadings || lines.front().trimmed() != QLatin1String(columns)) {
        throw Error(
            Text::tr(
                "The table of a step wedge must begin with the line %1 and have at most %2 lines")
                .arg(QLatin1String(columns))
                .arg(mostReadings),
            where);
    }
    std::vector<WedgeReading> readings;
    for (int line = 1; line < lines.size(); ++line) {
        const QStringList words = lines[line].trimmed().split(u',');
        // Lines without a reading are skipped.
        if (words.size() == 1 || words.back().trimmed().isEmpty()) {
            continue;
        }
        const std::vector<FilmInk> inks = inksOf(words.front().trimmed());
        const auto values = finiteNumbers(words.mid(1));
        if (words.size() != 6 || inks.empty() || !values) {
            throw Error(Text::tr("Line %1 of the table must contain an ink (cyan, magenta, yellow, "
                                 "black, white or grey) and five numbers, separated by commas")
                            .arg(line + 1),
                        where);
        }
        const std::vector<double>& v = *values;
        for (const FilmInk ink : inks) {
            readings.push_back({ink, v[0], v[1], v[2] * v[3] / (ruler * ruler), v[4], line + 1});
        }
    }
    return readings;
}

QByteArray blankWedge(const std::vector<WedgeInk>& rows, int stretches) {
    QByteArray table = columns + '\n';
    for (const WedgeInk& row : rows) {
        for (std::size_t tone = 0; tone < row.tones; ++tone) {
            const QByteArray line =
                inkName(row.ink).toUtf8() + ',' + QByteArray::number(wedgeTones[tone]) + ",,,,\n";
            table += line.repeated(stretches);
        }
    }
    return table;
}

} // namespace dipwright
