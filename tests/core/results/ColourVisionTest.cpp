// The colours of maps and marks are safe for colour-blind readers.
#include "ColourVision.h"
#include "results/ColourMap.h"
#include "results/Results.h"

#include <QtTest>

using namespace dipwright;

namespace {

constexpr double safe = 0.1; // distance in OKLab

QString description(const QColor& one, const QColor& other, ColourVision kind) {
    return QStringLiteral("%1 and %2 with colour vision %3: distance %4")
        .arg(one.name(), other.name())
        .arg(int(kind))
        .arg(seenDistance(one, other, kind));
}

} // namespace

class ColourVisionTest : public QObject {
    Q_OBJECT

private slots:
    void mapColour_sequentialMaps_growLighterWithAnyColourVision() {
        for (const char* map : {"lagoon", "dusk", "grey"}) {
            for (const ColourVision kind : allColourVisions) {
                for (int i = 0; i < 16; ++i) {
                    const double from = seen(mapColour(map, i / 16.0), kind)[0];
                    const double to = seen(mapColour(map, (i + 1) / 16.0), kind)[0];
                    QVERIFY2(to - from > 0.008,
                             qPrintable(QStringLiteral("%1 at %2").arg(map).arg(i)));
                }
            }
        }
    }

    void mapColour_balance_hasDifferentHalvesWithAnyColourVision() {
        for (const ColourVision kind : allColourVisions) {
            for (const double away : {0.25, 0.35, 0.5}) {
                const QColor low = mapColour("balance", 0.5 - away);
                const QColor high = mapColour("balance", 0.5 + away);
                QVERIFY2(seenDistance(low, high, kind) > safe,
                         qPrintable(description(low, high, kind)));
            }
        }
    }

    void colourAbove_differsFromItsMapWithAnyColourVision() {
        for (const QString& map : colourMaps()) {
            for (const ColourVision kind : allColourVisions) {
                for (int i = 0; i <= 32; ++i) {
                    const QColor within = mapColour(map, i / 32.0);
                    QVERIFY2(seenDistance(within, colourAbove(map), kind) > safe,
                             qPrintable(description(within, colourAbove(map), kind)));
                }
            }
        }
    }

    void colours_ofMarksAndPainters_differWithAnyColourVision() {
        const std::vector<QColor> marks{markColour(solver::PointMark::Torn),
                                        markColour(solver::PointMark::Unbalanced),
                                        markColour(solver::PointMark::LetGo)};
        const std::vector<QColor> painters{
            painterColour(Painter::None), painterColour(Painter::First),
            painterColour(Painter::Second), painterColour(Painter::Both)};
        for (const auto& colours : {marks, painters}) {
            for (std::size_t i = 0; i < colours.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    for (const ColourVision kind : allColourVisions) {
                        QVERIFY2(seenDistance(colours[i], colours[j], kind) > safe,
                                 qPrintable(description(colours[i], colours[j], kind)));
                    }
                }
            }
        }
    }
};

QTEST_GUILESS_MAIN(ColourVisionTest)
#include "ColourVisionTest.moc"
