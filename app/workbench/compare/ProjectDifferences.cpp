#include "workbench/compare/ProjectDifferences.h"

#include "base/NumberText.h"
#include "settings/SearchSettings.h"
#include "workbench/document/ProjectValue.h"
#include "workbench/project/PropertySpecs.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QLocale>
#include <algorithm>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ProjectDifferences)
};

QString valueText(const PropertySpec& spec, const QJsonValue& value, LengthUnit unit) {
    if (value.isArray()) {
        QStringList parts;
        for (const auto& part : value.toArray()) {
            parts << valueText(spec, part, unit);
        }
        return parts.join(QStringLiteral("; "));
    }
    if (value.isDouble()) {
        return roundedText(value.toDouble() * shownPerStored(spec.unit, unit), 6) +
               unitSuffix(spec.unit, unit);
    }
    if (value.isBool()) {
        return value.toBool() ? Text::tr("Yes") : Text::tr("No");
    }
    if (value.isString()) {
        return spec.words.value(value.toString(), value.toString());
    }
    return spec.absent.isEmpty() ? QStringLiteral("–") : spec.absent;
}

QString count(std::size_t number) {
    return QLocale().toString(qulonglong(number));
}

class Differences {
public:
    Differences(const Project& first, const Project& second, LengthUnit unit)
        : first_(first), second_(second), unit_(unit) {}

    void addPart(const ProjectNode& node) {
        for (const PropertySection& section : propertySections(node)) {
            for (const PropertySpec& spec : section.specs) {
                const QJsonValue before = valueAt(first_, spec.path);
                const QJsonValue after = valueAt(second_, spec.path);
                if (before != after) {
                    add(QStringLiteral("%1 · %2").arg(partName(node, first_), spec.label),
                        valueText(spec, before, unit_), valueText(spec, after, unit_));
                }
            }
        }
    }
    void add(const QString& setting, const QString& before, const QString& after) {
        if (before != after) {
            found_.push_back({setting, before, after});
        }
    }
    void addAims(const PoseAims& before, const PoseAims& after) {
        const auto number = [](double value) { return roundedText(value, 6); };
        const auto limit = [](Measure measure, const std::optional<double>& value) {
            return value ? measureText(measure, *value) : QStringLiteral("–");
        };
        for (const Measure measure : allMeasures()) {
            add(Text::tr("Pose search · weight of %1").arg(measureName(measure)),
                number(before.weights[measure]), number(after.weights[measure]));
            add(Text::tr("Pose search · limit of %1").arg(measureName(measure)),
                limit(measure, before.limits[measure]), limit(measure, after.limits[measure]));
        }
        for (std::size_t zone = 0; zone < zoneCount; ++zone) {
            add(Text::tr("Pose search · weight of zone %1").arg(QChar(u'A' + char16_t(zone))),
                number(before.zoneWeights[zone]), number(after.zoneWeights[zone]));
        }
    }
    // One entry for each layer, from the bottom up.
    void addArtwork(const Artwork& before, const Artwork& after) {
        const auto colour = [](const std::optional<QColor>& base) {
            return base ? base->name() : QStringLiteral("–");
        };
        add(Text::tr("Artwork · base colour"), colour(before.base), colour(after.base));
        for (std::size_t number = 0; number < std::max(before.layers.size(), after.layers.size());
             ++number) {
            const ArtworkLayer* first =
                number < before.layers.size() ? &before.layers[number] : nullptr;
            const ArtworkLayer* second =
                number < after.layers.size() ? &after.layers[number] : nullptr;
            QString shown = layerText(second);
            if (first && second && *first != *second && layerText(first) == shown) {
                shown = Text::tr("%1, with other settings").arg(shown);
            }
            add(Text::tr("Artwork · layer %1").arg(number + 1), layerText(first), shown);
        }
    }
    template <typename Mark>
    void addMarks(const QString& setting, const std::vector<Mark>& before,
                  const std::vector<Mark>& after) {
        const QString had = count(before.size()), has = count(after.size());
        add(setting, had, had == has && before != after ? Text::tr("%1 others").arg(has) : has);
    }
    std::vector<ProjectDifference> found() && { return std::move(found_); }

private:
    // “Logo, 40 × 30 mm at (0; −35; 0) mm, turned by 12°”
    QString layerText(const ArtworkLayer* layer) const {
        if (!layer) {
            return QStringLiteral("–");
        }
        const auto length = [this](Millimetres value) {
            return roundedText(value.value() * shownPerStored(Unit::Length, unit_), 4);
        };
        return Text::tr("%1, %2 × %3%7 at (%4; %5; %6)%7, turned by %8°")
            .arg(layer->name, length(layer->size[0]), length(layer->size[1]),
                 length(layer->place[0]), length(layer->place[1]), length(layer->place[2]),
                 unitSuffix(Unit::Length, unit_), roundedText(layer->turn.value(), 4));
    }

    const Project &first_, &second_;
    LengthUnit unit_;
    std::vector<ProjectDifference> found_;
};

} // namespace

std::vector<ProjectDifference> projectDifferences(const Project& first, const Project& second,
                                                  LengthUnit unit) {
    Differences differences(first, second, unit);
    for (const ProjectPart part :
         {ProjectPart::Project, ProjectPart::Model, ProjectPart::Film, ProjectPart::Process}) {
        differences.addPart({part, 0});
    }
    differences.add(Text::tr("Dips"), count(first.immersions.size()),
                    count(second.immersions.size()));
    const std::size_t both = std::min(first.immersions.size(), second.immersions.size());
    for (std::size_t number = 0; number < both; ++number) {
        differences.addPart({ProjectPart::Immersion, number});
    }
    for (const ProjectPart part :
         {ProjectPart::Share, ProjectPart::Sheet, ProjectPart::Ink, ProjectPart::Tolerance}) {
        differences.addPart({part, 0});
    }
    differences.addMarks(Text::tr("Marks for the seam"), first.share.marks, second.share.marks);
    differences.addMarks(Text::tr("Marks for zones"), first.tolerance.marks,
                         second.tolerance.marks);
    differences.addMarks(Text::tr("Marks for masks"), first.masks, second.masks);
    differences.addAims(first.poseAims, second.poseAims);
    const auto nameOfAny = [](const auto& profile) {
        return profile ? profile->name : QStringLiteral("–");
    };
    differences.add(Text::tr("Printer profile"), nameOfAny(first.profiles.printer),
                    nameOfAny(second.profiles.printer));
    differences.add(Text::tr("Film profile"), nameOfAny(first.profiles.film),
                    nameOfAny(second.profiles.film));
    differences.add(Text::tr("Tank profile"), nameOfAny(first.profiles.tank),
                    nameOfAny(second.profiles.tank));
    differences.addArtwork(first.artwork, second.artwork);
    return std::move(differences).found();
}

} // namespace dipwright
