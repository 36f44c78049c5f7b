#include "workbench/profiles/ProfileSpecs.h"

#include <QCoreApplication>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ProfileSpecs)
};

PropertySpec nameSpec() {
    return {.path = QStringLiteral("name"),
            .label = Text::tr("Name"),
            .help = Text::tr("What the profile is called in lists and in projects.")};
}

std::vector<PropertySpec> sides(const QByteArray& path, const QString& help) {
    const QMap<QString, QString> words{{QStringLiteral("free"), Text::tr("Free")},
                                       {QStringLiteral("pinned"), Text::tr("Held by a barrier")}};
    const auto side = [&](const char* name, const QString& label) {
        return PropertySpec{.path = QString::fromLatin1(path + '.' + name),
                            .label = label,
                            .help = help,
                            .words = words};
    };
    return {side("left", Text::tr("Left")), side("right", Text::tr("Right")),
            side("top", Text::tr("Top")), side("bottom", Text::tr("Bottom"))};
}

std::vector<PropertySection> printerSections() {
    PropertySection size{{}, {nameSpec()}};
    size.specs.push_back(
        {.path = QStringLiteral("queue"),
         .label = Text::tr("System's name"),
         .help = Text::tr("The name under which the system knows the printer. It is then chosen "
                          "at first when a sheet is printed.")});
    size.specs.push_back(
        {.path = QStringLiteral("scale"),
         .label = Text::tr("Scale"),
         .help = Text::tr("Printed length over true length, across the paper and along its feed. "
                          "Sheets are drawn smaller by it. “Calibrate Printer” measures it."),
         .unit = Unit::Ratio,
         .parts = {Text::tr("X"), Text::tr("Y")}});
    size.specs.push_back(
        {.path = QStringLiteral("margins_mm"),
         .label = Text::tr("Margins"),
         .help = Text::tr("What the printer does not reach at the paper's left, top, right and "
                          "bottom edge."),
         .unit = Unit::Length,
         .parts = {Text::tr("L", "left"), Text::tr("T", "top"), Text::tr("R", "right"),
                   Text::tr("B", "bottom")}});
    size.specs.push_back({.path = QStringLiteral("dpi"),
                          .label = Text::tr("Resolution"),
                          .help = Text::tr("Pixels an inch of the sheets for this printer."),
                          .unit = Unit::Resolution});
    PropertySection colour{Text::tr("Colour"), {}};
    colour.specs = {
        {.path = QStringLiteral("intent"),
         .label = Text::tr("Rendering intent"),
         .help = Text::tr("How colours that the printer cannot make are brought into its reach."),
         .words = {{QStringLiteral("perceptual"), Text::tr("Perceptual")},
                   {QStringLiteral("relative"), Text::tr("Relative colorimetric")},
                   {QStringLiteral("saturation"), Text::tr("Saturation")},
                   {QStringLiteral("absolute"), Text::tr("Absolute colorimetric")}}},
        {.path = QStringLiteral("black_point_compensation"),
         .label = Text::tr("Fit black point"),
         .help = Text::tr("Fits the darkest dark to what the printer can print, so that shadows "
                          "stay distinct.")},
        {.path = QStringLiteral("ink_limit"),
         .label = Text::tr("Ink limit"),
         .help = Text::tr("The highest optical density a channel that the film holds."),
         .unit = Unit::Density},
        {.path = QStringLiteral("total_ink"),
         .label = Text::tr("Total ink"),
         .help = Text::tr("Most of all four inks together on one place, with an ICC profile in "
                          "CMYK. Cyan, magenta and yellow give way, black stays."),
         .unit = Unit::Share,
         .absent = Text::tr("As the ICC profile has it"),
         .whenPresent = 3}};
    return {size, colour};
}

PropertySpec material(const char* path) {
    return specOf(QLatin1String(path), materialWords(QLatin1String(path)));
}

// What photos gave (dipwright-cli inspect film): where the figures above come from.
PropertySection filmMeasurement() {
    PropertySection measured{Text::tr("Measured by photos"), {}};
    measured.specs = {
        {.path = QStringLiteral("measured.date"),
         .label = Text::tr("Measured on"),
         .help = Text::tr("The day of the photos. While swell and growth are what they gave, the "
                          "profile counts as measured, else as guessed.")},
        {.path = QStringLiteral("measured.water_temperature_c"),
         .label = Text::tr("Water, °C"),
         .help = Text::tr("How warm the water was."),
         .absent = Text::tr("Not given"),
         .whenPresent = 25},
        {.path = QStringLiteral("measured.swell"),
         .label = Text::tr("Swell found"),
         .help = Text::tr("The swell that the photos gave. 0: none."),
         .unit = Unit::Ratio,
         .parts = {Text::tr("W", "width"), Text::tr("H", "height")}},
        {.path = QStringLiteral("measured.swell_off"),
         .label = Text::tr("… and off by"),
         .help = Text::tr("How far that swell may be off, at 95 %."),
         .unit = Unit::Ratio,
         .parts = {Text::tr("W", "width"), Text::tr("H", "height")}},
        {.path = QStringLiteral("measured.growth_per_s"),
         .label = Text::tr("Growth found"),
         .help = Text::tr("The growth that the photos gave."),
         .unit = Unit::ShareRate,
         .absent = Text::tr("Not given"),
         .whenPresent = 0},
        {.path = QStringLiteral("measured.growth_limit"),
         .label = Text::tr("… at most"),
         .help = Text::tr("The growth's limit that the photos gave."),
         .unit = Unit::Share,
         .absent = Text::tr("Not given"),
         .whenPresent = 0},
        {.path = QStringLiteral("measured.relaxation_time_s"),
         .label = Text::tr("Relaxation found"),
         .help = Text::tr("The relaxation time that photos of a dipped part gave."),
         .unit = Unit::Time,
         .absent = Text::tr("Not given"),
         .whenPresent = 0},
        {.path = QStringLiteral("measured.residual_mm"),
         .label = Text::tr("Residual"),
         .help = Text::tr("How far the corners in the photos lie from where these figures have "
                          "them, on the average."),
         .unit = Unit::Length},
        {.path = QStringLiteral("measured.photos"),
         .label = Text::tr("Photos"),
         .help = Text::tr("The SHA-256 of the photos' files, by which they can be known again.")}};
    return measured;
}

PropertySection filmPackage() {
    PropertySection film{{}, {nameSpec()}};
    film.specs.push_back({.path = QStringLiteral("size_mm"),
                          .label = Text::tr("Size"),
                          .help = Text::tr("Width and height of the dry film."),
                          .unit = Unit::Length,
                          .parts = {Text::tr("W", "width"), Text::tr("H", "height")}});
    film.specs.push_back(
        {.path = QStringLiteral("feed"),
         .label = Text::tr("Feed"),
         .help = Text::tr("The edge that goes into the printer first: a film swells more along "
                          "its web."),
         .words = {{QStringLiteral("short edge first"), Text::tr("Short edge first")},
                   {QStringLiteral("long edge first"), Text::tr("Long edge first")}}});
    film.specs.push_back(
        {.path = QStringLiteral("lot"),
         .label = Text::tr("Lot"),
         .help = Text::tr("The maker's number: another lot may swell otherwise.")});
    film.specs.push_back({.path = QStringLiteral("expiry"),
                          .label = Text::tr("Use before"),
                          .help = Text::tr("A date such as 2027-03-31, or nothing.")});
    return film;
}

std::vector<PropertySection> filmSections() {
    PropertySection water{Text::tr("Behaviour on the water"), {}};
    water.specs = {
        material("swell"),
        material("relaxation_time_s"),
        material("growth_per_s"),
        material("growth_limit"),
        material("ink_exponents"),
        material("ink_black_white_exponents"),
        material("ink_tones"),
        material("contact_distance_mm"),
        {.path = QStringLiteral("soak_time_s"),
         .label = Text::tr("Soak time"),
         .help = Text::tr("From the water to the activator."),
         .unit = Unit::Time},
        {.path = QStringLiteral("activator_time_s"),
         .label = Text::tr("Activator time"),
         .help = Text::tr("From the activator to the dip."),
         .unit = Unit::Time},
        {.path = QStringLiteral("flash_time_s"),
         .label = Text::tr("Flash time"),
         .help = Text::tr("From the dip to the rinse."),
         .unit = Unit::Time,
         .absent = Text::tr("Not given"),
         .whenPresent = 60},
        {.path = QStringLiteral("drying_time_s"),
         .label = Text::tr("Drying time"),
         .help = Text::tr("From the rinse until the body may be touched, or dipped again."),
         .unit = Unit::Time,
         .absent = Text::tr("Not given"),
         .whenPresent = 3600}};
    return {filmPackage(),
            water,
            filmMeasurement(),
            {Text::tr("Sides"),
             {material("edges.left"), material("edges.right"), material("edges.top"),
              material("edges.bottom")}},
            {Text::tr("Advanced: laws without measurement"),
             {material("overhang_deg"), material("grip_fade_deg"), material("tear_stretch"),
              material("gathering_stretch")}}};
}

std::vector<PropertySection> tankSections() {
    PropertySection tank{{}, {nameSpec()}};
    tank.specs.push_back({.path = QStringLiteral("size_mm"),
                          .label = Text::tr("Size"),
                          .help = Text::tr("Width and length of the water."),
                          .unit = Unit::Length,
                          .parts = {Text::tr("W", "width"), Text::tr("L", "length")}});
    tank.specs.push_back({.path = QStringLiteral("water_level_mm"),
                          .label = Text::tr("Water level"),
                          .help = Text::tr("How far the water stands under the tank's rim."),
                          .unit = Unit::Length});
    tank.specs.push_back(
        {.path = QStringLiteral("mark_distance_mm"),
         .label = Text::tr("Marks"),
         .help = Text::tr("Between the tank's marks, across and along, which the sheet's "
                          "registration marks are laid to. 0: there are none."),
         .unit = Unit::Length,
         .parts = {Text::tr("X"), Text::tr("Y")}});
    return {tank,
            {Text::tr("Barriers"),
             sides("barriers", Text::tr("Whether a barrier in the tank holds this side of the "
                                        "film."))}};
}

} // namespace

std::vector<PropertySection> profileSections(ProfileKind kind) {
    switch (kind) {
    case ProfileKind::Printer:
        return printerSections();
    case ProfileKind::Film:
        return filmSections();
    case ProfileKind::Tank:
        break;
    }
    return tankSections();
}

} // namespace dipwright
