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
            .help = Text::tr("The name of the profile in lists and projects.")};
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

PropertySection inkCosts() {
    PropertySection costs{Text::tr("Cost of the ink"), {}};
    const QStringList inks{Text::tr("C", "cyan"), Text::tr("M", "magenta"), Text::tr("Y", "yellow"),
                           Text::tr("K", "black")};
    const QStringList spots{Text::tr("White"), Text::tr("Other", "spot inks")};
    costs.specs = {
        {.path = QStringLiteral("cost.ink_ml_per_m2"),
         .label = Text::tr("Ink at full tint, ml/m²"),
         .help = Text::tr("Millilitres of each ink on a square metre that is printed at full tint. "
                          "Usual values are 5 to 20. 0: not given."),
         .parts = inks},
        {.path = QStringLiteral("cost.ink_price_per_l"),
         .label = Text::tr("Price of a litre"),
         .help = Text::tr("Price of a litre of each ink, in the currency of the tank's profile. 0: "
                          "not given."),
         .parts = inks},
        {.path = QStringLiteral("cost.spot_ml_per_m2"),
         .label = Text::tr("Spot ink at full tint, ml/m²"),
         .help = Text::tr("The same for white and for every other spot ink. 0: not given."),
         .parts = spots},
        {.path = QStringLiteral("cost.spot_price_per_l"),
         .label = Text::tr("Price of a litre of spot ink"),
         .help = Text::tr("The price of white and of every other spot ink. 0: not given."),
         .parts = spots}};
    return costs;
}

PropertySection filmCosts() {
    PropertySection costs{Text::tr("Cost of the film"), {}};
    costs.specs = {
        {.path = QStringLiteral("cost.film_price"),
         .label = Text::tr("Price"),
         .help = Text::tr("Price of the film for the unit below, in the currency of the tank's "
                          "profile."),
         .absent = Text::tr("Not given"),
         .whenPresent = 10},
        {.path = QStringLiteral("cost.film_price_per"),
         .label = Text::tr("Price for"),
         .help = Text::tr("What the price is for. A metre of roll is as wide as the film is cut."),
         .words = {{QStringLiteral("m2"), Text::tr("A square metre")},
                   {QStringLiteral("roll metre"), Text::tr("A metre of roll")},
                   {QStringLiteral("sheet"), Text::tr("A sheet")}}}};
    return costs;
}

PropertySection workCosts() {
    PropertySection costs{Text::tr("Work"), {}};
    const QString absent = Text::tr("Not given");
    costs.specs = {
        {.path = QStringLiteral("cost.labour_per_h"),
         .label = Text::tr("Price of an hour"),
         .help = Text::tr("Price of an hour of work at the tank. Set-up, handling, soak, activator "
                          "and dip count as work; flash and drying do not."),
         .absent = absent,
         .whenPresent = 40},
        {.path = QStringLiteral("cost.setup_min"),
         .label = Text::tr("Set-up, minutes"),
         .help = Text::tr("Minutes of work before the first dip of an order."),
         .absent = absent,
         .whenPresent = 15},
        {.path = QStringLiteral("cost.handling_min"),
         .label = Text::tr("Handling, minutes"),
         .help = Text::tr("Minutes of work for each dip of a rack, in addition to the timed steps: "
                          "laying the film, mounting, rinsing."),
         .absent = absent,
         .whenPresent = 3},
        {.path = QStringLiteral("cost.parts_per_rack"),
         .label = Text::tr("Parts per rack"),
         .help = Text::tr("How many parts one dip with one sheet makes. More than 1 only if the "
                          "model shows several parts on a jig.")},
        {.path = QStringLiteral("cost.scrap"),
         .label = Text::tr("Scrap"),
         .help = Text::tr("Share of the dipped racks that cannot be sold. Film, ink and work are "
                          "counted for them, too. Usual values are 2 to 10 %."),
         .unit = Unit::Share},
        {.path = QStringLiteral("cost.currency"),
         .label = Text::tr("Currency"),
         .help = Text::tr("The currency of all prices, for example EUR.")}};
    return costs;
}

PropertySection printerFiles() {
    PropertySection files{Text::tr("PDF and TIFF files"), {}};
    files.specs = {
        {.path = QStringLiteral("pdf_target"),
         .label = Text::tr("PDF for"),
         .help = Text::tr(
             "The RIP that reads the CMYK PDF. For Ghostscript, white and spot colours blend as "
             "transparency, which looks right on every screen, too. For the Adobe PDF Print Engine "
             "they overprint. For older RIPs they overprint in a PDF/X-1a file. Viewers that "
             "ignore overprint show white over the colours."),
         .words = {{QStringLiteral("ghostscript"), Text::tr("Ghostscript, viewers")},
                   {QStringLiteral("adobe"), Text::tr("Adobe PDF Print Engine")},
                   {QStringLiteral("older"), Text::tr("Older RIPs")}}},
        {.path = QStringLiteral("square_pixels"),
         .label = Text::tr("Square pixels in TIFF"),
         .help = Text::tr(
             "Gives TIFF files one resolution. If the scales X and Y differ, the image is "
             "resampled, which softens it slightly. Without this, the file has two resolutions, "
             "which some RIPs ignore.")}};
    return files;
}

PropertySection printerRolls() {
    PropertySection rolls{Text::tr("Roll"), {}};
    rolls.specs = {
        {.path = QStringLiteral("roll_gap_mm"),
         .label = Text::tr("Gap in a series"),
         .help = Text::tr(
             "Bare film between the sheets of a series, which is printed on the roll as one job, "
             "with cut marks and the number of each copy in the gap. Usual values are 5 to 20 mm. "
             "Without it, each sheet is a page of its own."),
         .unit = Unit::Length,
         .absent = Text::tr("Single pages"),
         .whenPresent = 10},
        {.path = QStringLiteral("roll_width_mm"),
         .label = Text::tr("Width of the roll"),
         .help = Text::tr("Width of the loaded roll, as far as it can be printed. Give it if the "
                          "printer does not report its roll."),
         .unit = Unit::Length,
         .absent = Text::tr("As the printer reports"),
         .whenPresent = 610}};
    return rolls;
}

std::vector<PropertySection> printerSections() {
    PropertySection size{{}, {nameSpec()}};
    size.specs.push_back({.path = QStringLiteral("queue"),
                          .label = Text::tr("System name"),
                          .help = Text::tr("The printer's name in the operating system. The print "
                                           "dialog selects this printer first.")});
    size.specs.push_back(
        {.path = QStringLiteral("scale"),
         .label = Text::tr("Scale"),
         .help = Text::tr("Printed length divided by intended length, across the paper (X) and "
                          "along its feed (Y). Sheets are divided by this factor, so that they "
                          "print at true size. “Calibrate printer” measures the factor."),
         .unit = Unit::Ratio,
         .parts = {Text::tr("X"), Text::tr("Y")}});
    size.specs.push_back(
        {.path = QStringLiteral("margins_mm"),
         .label = Text::tr("Margins"),
         .help = Text::tr("The margins that the printer cannot reach at the left (L), top (T), "
                          "right (R) and bottom (B) edge of the paper."),
         .unit = Unit::Length,
         .parts = {Text::tr("L", "left"), Text::tr("T", "top"), Text::tr("R", "right"),
                   Text::tr("B", "bottom")}});
    size.specs.push_back({.path = QStringLiteral("dpi"),
                          .label = Text::tr("Resolution"),
                          .help = Text::tr("Pixels per inch of the sheets for this printer."),
                          .unit = Unit::Resolution});
    PropertySection colour{Text::tr("Colour"), {}};
    colour.specs = {
        {.path = QStringLiteral("intent"),
         .label = Text::tr("Rendering intent"),
         .help =
             Text::tr("How out-of-gamut colours are mapped to colours that the printer can print."),
         .words = {{QStringLiteral("perceptual"), Text::tr("Perceptual")},
                   {QStringLiteral("relative"), Text::tr("Relative colorimetric")},
                   {QStringLiteral("saturation"), Text::tr("Saturation")},
                   {QStringLiteral("absolute"), Text::tr("Absolute colorimetric")}}},
        {.path = QStringLiteral("black_point_compensation"),
         .label = Text::tr("Black point compensation"),
         .help = Text::tr("Maps the darkest colour of the image to the darkest colour that the "
                          "printer can print, so that shadows stay distinct.")},
        {.path = QStringLiteral("kept_inks"),
         .label = Text::tr("Pure inks"),
         .help =
             Text::tr("What is printed in one ink alone instead of a mixture. “Black”: greys of "
                      "RGB pictures, and black alone in CMYK pictures. “All”: cyan, magenta "
                      "and yellow alone, too. Keeps text and lines sharp. CMYK pictures in the "
                      "printer's own ICC profile always keep their amounts of ink, unless a "
                      "device link from CMYK converts them."),
         .words = {{QStringLiteral("none"), Text::tr("As the ICC profile mixes them")},
                   {QStringLiteral("black"), Text::tr("Black")},
                   {QStringLiteral("pure"), Text::tr("All")}}},
        {.path = QStringLiteral("ink_limit"),
         .label = Text::tr("Ink limit"),
         .help = Text::tr("The highest optical density per channel that the film holds."),
         .unit = Unit::Density},
        {.path = QStringLiteral("total_ink"),
         .label = Text::tr("Total area coverage"),
         .help = Text::tr(
             "The largest sum of the four inks at one place (TAC). Where the sum is larger, cyan, "
             "magenta and yellow are reduced; black stays. Used only with a CMYK ICC profile."),
         .unit = Unit::Share,
         .absent = Text::tr("From the ICC profile"),
         .whenPresent = 3}};
    return {size, colour, printerFiles(), printerRolls(), inkCosts()};
}

PropertySpec material(const char* path) {
    return specOf(QLatin1String(path), materialWords(QLatin1String(path)));
}

// The measurement from photos (dipwright-cli inspect film), the source of the values above.
PropertySection filmMeasurement() {
    PropertySection measured{Text::tr("Measured from photos"), {}};
    measured.specs = {
        {.path = QStringLiteral("measured.date"),
         .label = Text::tr("Measured on"),
         .help = Text::tr("The date of the photos. The profile counts as measured as long as swell "
                          "and growth have the values from the photos.")},
        {.path = QStringLiteral("measured.water_temperature_c"),
         .label = Text::tr("Water temperature, °C"),
         .help = Text::tr("The temperature of the water in the photos."),
         .absent = Text::tr("Not given"),
         .whenPresent = 25},
        {.path = QStringLiteral("measured.swell"),
         .label = Text::tr("Measured swell"),
         .help = Text::tr(
             "The swell measured from the photos, in width (W) and height (H). 0: not measured."),
         .unit = Unit::Ratio,
         .parts = {Text::tr("W", "width"), Text::tr("H", "height")}},
        {.path = QStringLiteral("measured.swell_off"),
         .label = Text::tr("Swell error"),
         .help = Text::tr("Uncertainty of the measured swell (±, 95 % confidence), in width (W) "
                          "and height (H)."),
         .unit = Unit::Ratio,
         .parts = {Text::tr("W", "width"), Text::tr("H", "height")}},
        {.path = QStringLiteral("measured.growth_per_s"),
         .label = Text::tr("Measured growth"),
         .help = Text::tr("The growth measured from the photos."),
         .unit = Unit::ShareRate,
         .absent = Text::tr("Not given"),
         .whenPresent = 0},
        {.path = QStringLiteral("measured.growth_limit"),
         .label = Text::tr("Measured growth limit"),
         .help = Text::tr("The limit of the growth, measured from the photos."),
         .unit = Unit::Share,
         .absent = Text::tr("Not given"),
         .whenPresent = 0},
        {.path = QStringLiteral("measured.relaxation_time_s"),
         .label = Text::tr("Measured relaxation"),
         .help = Text::tr("The relaxation time measured from photos of a dipped part."),
         .unit = Unit::Time,
         .absent = Text::tr("Not given"),
         .whenPresent = 0},
        {.path = QStringLiteral("measured.residual_mm"),
         .label = Text::tr("Residual"),
         .help = Text::tr("Average distance between the corners of the printed squares in the "
                          "photos and their positions computed from these values."),
         .unit = Unit::Length},
        {.path = QStringLiteral("measured.photos"),
         .label = Text::tr("Photos"),
         .help = Text::tr("The SHA-256 checksums of the photo files, to identify them.")}};
    return measured;
}

PropertySection filmPackage() {
    PropertySection film{{}, {nameSpec()}};
    film.specs.push_back({.path = QStringLiteral("size_mm"),
                          .label = Text::tr("Size"),
                          .help = Text::tr("Width (W) and height (H) of the dry film."),
                          .unit = Unit::Length,
                          .parts = {Text::tr("W", "width"), Text::tr("H", "height")}});
    film.specs.push_back(
        {.path = QStringLiteral("feed"),
         .label = Text::tr("Feed"),
         .help =
             Text::tr("The edge that enters the printer first. Film swells more along its web."),
         .words = {{QStringLiteral("short edge first"), Text::tr("Short edge first")},
                   {QStringLiteral("long edge first"), Text::tr("Long edge first")}}});
    film.specs.push_back(
        {.path = QStringLiteral("lot"),
         .label = Text::tr("Lot"),
         .help = Text::tr("The manufacturer's lot number. Another lot may swell differently.")});
    film.specs.push_back({.path = QStringLiteral("expiry"),
                          .label = Text::tr("Use by"),
                          .help = Text::tr("A date such as 2027-03-31. May be empty.")});
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
         .help = Text::tr("Time from laying the film on the water to spraying the activator."),
         .unit = Unit::Time},
        {.path = QStringLiteral("activator_time_s"),
         .label = Text::tr("Activator time"),
         .help = Text::tr("Time from spraying the activator to the dip."),
         .unit = Unit::Time},
        {.path = QStringLiteral("flash_time_s"),
         .label = Text::tr("Flash time"),
         .help = Text::tr("Time from the dip to the rinse."),
         .unit = Unit::Time,
         .absent = Text::tr("Not given"),
         .whenPresent = 60},
        {.path = QStringLiteral("drying_time_s"),
         .label = Text::tr("Drying time"),
         .help = Text::tr("Time from the rinse until the part may be touched or dipped again."),
         .unit = Unit::Time,
         .absent = Text::tr("Not given"),
         .whenPresent = 3600}};
    return {filmPackage(),
            water,
            filmMeasurement(),
            {Text::tr("Sides"),
             {material("edges.left"), material("edges.right"), material("edges.top"),
              material("edges.bottom")}},
            filmCosts(),
            {Text::tr("Advanced: material laws that are not measured"),
             {material("overhang_deg"), material("grip_fade_deg"), material("tear_stretch"),
              material("gathering_stretch")}}};
}

std::vector<PropertySection> tankSections() {
    PropertySection tank{{}, {nameSpec()}};
    tank.specs.push_back({.path = QStringLiteral("size_mm"),
                          .label = Text::tr("Size"),
                          .help = Text::tr("Width (W) and length (L) of the water surface."),
                          .unit = Unit::Length,
                          .parts = {Text::tr("W", "width"), Text::tr("L", "length")}});
    tank.specs.push_back({.path = QStringLiteral("water_level_mm"),
                          .label = Text::tr("Water level"),
                          .help = Text::tr("Distance from the tank's rim down to the water."),
                          .unit = Unit::Length});
    tank.specs.push_back(
        {.path = QStringLiteral("mark_distance_mm"),
         .label = Text::tr("Mark spacing"),
         .help =
             Text::tr("Distance between the tank's marks, across (X) and along (Y) the tank. The "
                      "sheet's registration marks are aligned with the tank's marks. 0: no marks."),
         .unit = Unit::Length,
         .parts = {Text::tr("X"), Text::tr("Y")}});
    const QString absent = Text::tr("Not given");
    return {
        tank,
        {Text::tr("Limits"),
         {{.path = QStringLiteral("water_depth_mm"),
           .label = Text::tr("Water depth"),
           .help = Text::tr("Distance from the water surface to the tank's floor. The verdict on "
                            "a dip that goes deeper is “Do not print”."),
           .unit = Unit::Length,
           .absent = absent,
           .whenPresent = 300},
          {.path = QStringLiteral("reach_mm"),
           .label = Text::tr("Reach"),
           .help = Text::tr("How far the machine can move the centre of a part sideways from "
                            "the middle of the tank."),
           .unit = Unit::Length,
           .absent = absent,
           .whenPresent = 100},
          {.path = QStringLiteral("speed_mm_s"),
           .label = Text::tr("Fastest motion"),
           .help = Text::tr("The highest speed at which the machine moves a part."),
           .unit = Unit::Speed,
           .absent = absent,
           .whenPresent = 50},
          {.path = QStringLiteral("turn_speed_deg_s"),
           .label = Text::tr("Fastest turn"),
           .help = Text::tr("The highest speed at which the machine turns a part."),
           .unit = Unit::AngularSpeed,
           .absent = absent,
           .whenPresent = 30}}},
        {Text::tr("Barriers"),
         sides("barriers", Text::tr("Whether a barrier in the tank holds this side of the "
                                    "film."))},
        workCosts()};
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
