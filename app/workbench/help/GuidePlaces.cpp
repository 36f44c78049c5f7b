#include "workbench/help/GuidePlaces.h"

#include <QCoreApplication>
#include <QMap>
#include <QTabWidget>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(GuidePlaces)
};

enum Chapter {
    FirstSheet,
    Window,
    Artwork,
    Film,
    Immersions,
    Dipping,
    Results,
    Verdict,
    Paths,
    Printing,
    Projects,
    Wrong
};

// Keys are widget names, with the number of the shown tab or of the project's page. The words must
// occur in the guide of each language.
QMap<QString, GuidePlace> placesByName() {
    const GuidePlace numericalError{Results, Text::tr("Dip ▸ Check numerical error")};
    const GuidePlace tolerances{Results, Text::tr("Dip ▸ Tolerances")};
    const GuidePlace newProject{FirstSheet, Text::tr("File ▸ New project")};
    QMap<QString, GuidePlace> places{
        {QStringLiteral("startPage"), newProject},
        {QStringLiteral("newProjectDialog"), newProject},
        {QStringLiteral("projectTree"), {Window, Text::tr("Left")}},
        {QStringLiteral("view"), {Window, Text::tr("Middle")}},
        {QStringLiteral("timeline"), {Window, Text::tr("timeline")}},
        {QStringLiteral("preferencesDialog"), {Window, {}}},
        {QStringLiteral("artworkPage"), {Artwork, {}}},
        {QStringLiteral("propertyPanel/0"), {Projects, {}}},
        {QStringLiteral("propertyPanel/1"), {Projects, Text::tr("Reload model")}},
        {QStringLiteral("propertyPanel/2"), {Film, {}}},
        {QStringLiteral("propertyPanel/3"), {Dipping, {}}},
        {QStringLiteral("propertyPanel/4"), {Immersions, {}}},
        {QStringLiteral("propertyPanel/5"), {Immersions, Text::tr("Seam")}},
        {QStringLiteral("propertyPanel/6"), {Printing, Text::tr("File ▸ Print")}},
        {QStringLiteral("propertyPanel/7"), {Printing, Text::tr("ICC profile")}},
        {QStringLiteral("propertyPanel/8"), tolerances},
        {QStringLiteral("searchPage"), {Immersions, Text::tr("Dip ▸ Find poses")}},
        {QStringLiteral("searchedPaths"), {Paths, {}}},
        {QStringLiteral("results/0"), {Verdict, {}}},
        {QStringLiteral("results/1"), {Results, Text::tr("Stretch")}},
        {QStringLiteral("results/2"), {Results, Text::tr("Texture")}},
        {QStringLiteral("results/3"), {Results, Text::tr("Proof")}},
        {QStringLiteral("results/4"), {Results, Text::tr("Sheet")}},
        {QStringLiteral("results/5"), {Results, Text::tr("Report")}},
        {QStringLiteral("certaintyDialog"), numericalError},
        {QStringLiteral("toleranceDialog"), tolerances},
        {QStringLiteral("printDialog"), {Printing, Text::tr("File ▸ Print")}},
        {QStringLiteral("platesDialog"), {Printing, Text::tr("File ▸ Plates")}},
        {QStringLiteral("printHistory"), {Printing, Text::tr("File ▸ Print history")}},
        {QStringLiteral("calibrationDialog"), {Printing, Text::tr("File ▸ Calibrate printer")}},
        {QStringLiteral("profilesDialog"), {Printing, Text::tr("Edit ▸ Profiles")}},
        {QStringLiteral("inspection/0"), {Printing, Text::tr("Measuring a dipped part")}},
        {QStringLiteral("inspection/1"), {Printing, Text::tr("Fit")}},
        {QStringLiteral("inspection/2"), {Printing, Text::tr("As built")}},
        {QStringLiteral("inspection/3"), {Printing, Text::tr("Measuring a film")}},
        {QStringLiteral("snapshots"), {Projects, Text::tr("File ▸ Snapshots")}},
        {QStringLiteral("jobQueue"), {Projects, Text::tr("File ▸ Job queue")}},
        {QStringLiteral("serverDialog"), {Projects, Text::tr("Dip ▸ Send to server")}},
        {QStringLiteral("tankPage"), {Printing, Text::tr("At the tank")}},
        {QStringLiteral("logDock"), {Wrong, Text::tr("log")}},
    };
    for (const QString& dip :
         {QStringLiteral("immersions[0].path."), QStringLiteral("immersions[1].path.")}) {
        for (const char* field :
             {"kind", "angle_deg", "heading_deg", "level_depth_mm", "roll_radius_mm", "turn_deg",
              "water_speed_mm_s", "slow_speed_mm_s", "slow_mm"}) {
            places.insert(dip + QLatin1String(field), {Paths, {}});
        }
    }
    return places;
}

QString keyOf(const QWidget& widget) {
    const QVariant part = widget.property("part");
    const auto* tabs = qobject_cast<const QTabWidget*>(&widget);
    const int number = tabs ? tabs->currentIndex() : part.isValid() ? part.toInt() : -1;
    return number < 0 ? widget.objectName()
                      : QStringLiteral("%1/%2").arg(widget.objectName()).arg(number);
}

} // namespace

GuidePlace guidePlaceOf(const QWidget* widget) {
    const QMap<QString, GuidePlace> places = placesByName();
    for (; widget; widget = widget->parentWidget()) {
        const auto place = places.find(keyOf(*widget));
        if (place != places.end()) {
            return *place;
        }
    }
    return {};
}

std::vector<GuidePlace> guidePlaces() {
    const QMap<QString, GuidePlace> places = placesByName();
    return {places.begin(), places.end()};
}

} // namespace dipwright
