#include "workbench/project/PropertySpecs.h"

#include <QCoreApplication>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PropertySpecs)
};

bool isProduction(const Project& project) {
    return solver::isProductionFilm(project.film.lattice, project.film.support);
}

bool isPaperModel(const Project& project) {
    return !isProduction(project);
}

// `path` as a film profile has it.
PropertySpec material(const QString& section, const char* path) {
    const FieldWords words = materialWords(QLatin1String(path));
    PropertySpec spec = specOf(section + QLatin1String(path), words);
    if (words.isOfProductionFilm) {
        spec.relevant = isProduction;
    }
    return spec;
}

std::vector<PropertySection> projectProperties() {
    return {{{},
             {{.path = QStringLiteral("name"),
               .label = Text::tr("Name"),
               .help = Text::tr("What the project is called. It stands in the job line of every "
                                "sheet.")},
              {.path = QStringLiteral("created"),
               .label = Text::tr("Date"),
               .help = Text::tr("The date in the job line. It belongs to the project, so that the "
                                "same project always gives the same sheet.")}}}};
}

std::vector<PropertySection> modelProperties() {
    return {{Text::tr("Distance field"),
             {{.path = QStringLiteral("body.sdf_resolution"),
               .label = Text::tr("Resolution"),
               .help = Text::tr("Samples along each edge of the cube round the body in which the "
                                "distance to its surface is kept. More follows finer detail and "
                                "takes longer to build.")}}}};
}

PropertySection printedFilmProperties() {
    PropertySection printed{Text::tr("Printed film"), {}};
    printed.specs = {
        {.path = QStringLiteral("film.preset"),
         .label = Text::tr("Format"),
         .help = Text::tr("The size in which the film comes and is printed."),
         .words = {{QStringLiteral("custom"), Text::tr("Custom")}}},
        {.path = QStringLiteral("film.size_mm"),
         .label = Text::tr("Size"),
         .help = Text::tr("Width and height of the printed film. The grid keeps its spacing."),
         .unit = Unit::Length,
         .parts = {Text::tr("W", "width"), Text::tr("H", "height")}},
        {.path = QStringLiteral("film.resolution"),
         .label = Text::tr("Resolution"),
         .help = Text::tr("How fine the simulated film is. Automatic chooses the size of its cells "
                          "from the body's narrow parts and its pose: fine where the body comes "
                          "down, coarse towards the film's edges."),
         .words = {{QStringLiteral("automatic"), Text::tr("Automatic")},
                   {QStringLiteral("cell"), Text::tr("Size of the cells")},
                   {QStringLiteral("points"), Text::tr("Number of points")}},
         .relevant = isProduction},
        {.path = QStringLiteral("film.cell_mm"),
         .label = Text::tr("Cells"),
         .help = Text::tr("The side of the simulated film's cells where the body comes down. "
                          "Smaller cells show finer detail and take longer."),
         .unit = Unit::Length,
         .relevant =
             [](const Project& project) {
                 return isProduction(project) && project.film.resolution == FilmResolution::Cell;
             }},
        {.path = QStringLiteral("film.points"),
         .label = Text::tr("Points"),
         .help = Text::tr("Points of the simulated film across and down. More points show finer "
                          "detail and take longer."),
         .parts = {Text::tr("W", "width"), Text::tr("H", "height")},
         .relevant = [](const Project& project) {
             return isPaperModel(project) || project.film.resolution == FilmResolution::Points;
         }}};
    return printed;
}

std::vector<PropertySection> filmProperties() {
    const QString film = QStringLiteral("film.");
    PropertySection floating{Text::tr("Behaviour on the water"), {}};
    floating.specs = {
        material(film, "swell"),
        material(film, "relaxation_time_s"),
        material(film, "growth_per_s"),
        material(film, "growth_limit"),
        material(film, "contact_distance_mm"),
        {.path = QStringLiteral("film.lattice"),
         .label = Text::tr("Film model"),
         .help = Text::tr("Isotropic film resists shear and gives the same result whichever way "
                          "the grid lies. The structural lattice joins horizontal and vertical "
                          "neighbours only, as in the paper of 2020."),
         .words = {{QStringLiteral("isotropic"), Text::tr("Isotropic")},
                   {QStringLiteral("structural"), Text::tr("Structural lattice")}}},
        {.path = QStringLiteral("film.support"),
         .label = Text::tr("Support"),
         .help = Text::tr("Whether the water holds up the free film. Without it nothing does."),
         .words = {{QStringLiteral("water"), Text::tr("Water")},
                   {QStringLiteral("none"), Text::tr("None")}}}};

    return {printedFilmProperties(),
            floating,
            {Text::tr("Sides"),
             {material(film, "edges.left"), material(film, "edges.right"),
              material(film, "edges.top"), material(film, "edges.bottom")}},
            {Text::tr("Advanced: laws without measurement"),
             {material(film, "grip_fade_deg"), material(film, "gathering_stretch")}}};
}

PropertySection cradleProperties() {
    const auto length = [](const char* path, const QString& label, const QString& help) {
        return PropertySpec{
            .path = QLatin1String(path), .label = label, .help = help, .unit = Unit::Length};
    };
    const auto isOnPaint = [](const Project& project) { return project.cradle.onPaint; };
    PropertySection cradle{Text::tr("Cradle"), {}};
    cradle.specs = {
        length("cradle.clearance_mm", Text::tr("Clearance"),
               Text::tr("How far the cradle keeps off the body that lies in it.")),
        length("cradle.wall_mm", Text::tr("Walls"),
               Text::tr("How thick what holds the body is, at its thinnest.")),
        length("cradle.reach_mm", Text::tr("Reaches down"),
               Text::tr("How far below the body's top the cradle reaches. It goes deeper where the "
                        "body would tip or slide.")),
        length("cradle.paint_distance_mm", Text::tr("Off the film"),
               Text::tr("How far the cradle keeps off all that the film reaches, and off what "
                        "earlier dips have painted.")),
        {.path = QStringLiteral("cradle.on_paint"),
         .label = Text::tr("On paint"),
         .help = Text::tr("Whether the cradle may lie on what earlier dips have painted, through "
                          "padding.")},
        {.path = QStringLiteral("cradle.padding_mm"),
         .label = Text::tr("Padding"),
         .help = Text::tr("Room that is left for felt or foam where the cradle lies on paint."),
         .unit = Unit::Length,
         .relevant = isOnPaint},
        length("cradle.plate_thickness_mm", Text::tr("Plate"),
               Text::tr("How thick the plate is that the cradle hangs from.")),
        length("cradle.standoff_mm", Text::tr("Off the water"),
               Text::tr("How far the plate stays above the water at the end of the dip.")),
        length("cradle.pin_span_mm", Text::tr("Pins apart"),
               Text::tr("How far apart two of the datum pins are at most. They stand where the "
                        "sheet's marks float, or are drawn in towards the film's middle.")),
        length("cradle.pin_diameter_mm", Text::tr("Pins"),
               Text::tr("The diameter of the datum pins of the tank's frame.")),
        length("cradle.pin_clearance_mm", Text::tr("Pin clearance"),
               Text::tr("How much wider than the pins their holes are, all round.")),
        length("cradle.bore_mm", Text::tr("Bore"),
               Text::tr("A hole through plate and seat, to fix the body by a screw, suction or hot "
                        "glue. At 0 there is none.")),
        length("cradle.engraving_mm", Text::tr("Engraving"),
               Text::tr("How deep arrow, number and job are cut into the plate. At 0 they are "
                        "not.")),
        length("cradle.cell_mm", Text::tr("Fineness"),
               Text::tr("The side of the cells that the cradle's form is computed on. Smaller is "
                        "smoother, slower and makes larger files."))};
    return cradle;
}

std::vector<PropertySection> processProperties() {
    PropertySection motion{Text::tr("Motion"), {}};
    motion.specs = {
        {.path = QStringLiteral("process.dip_speed_mm_s"),
         .label = Text::tr("Speed"),
         .help = Text::tr("How fast the body comes down into the water."),
         .unit = Unit::Speed},
        {.path = QStringLiteral("process.depth_mm"),
         .label = Text::tr("Depth"),
         .help = Text::tr("How far the lowest point of the body goes under the waterline. “Whole "
                          "body” dips until all of it is under."),
         .unit = Unit::Length,
         .absent = Text::tr("Whole body"),
         .whenPresent = 20},
        {.path = QStringLiteral("process.margin_mm"),
         .label = Text::tr("Margin"),
         .help = Text::tr("How much farther than fully under the body is dipped."),
         .unit = Unit::Length,
         .relevant = [](const Project& project) { return !project.process.depth; }}};

    const QString process = QStringLiteral("process.");
    const PropertySection limits{
        Text::tr("Limits"), {material(process, "tear_stretch"), material(process, "overhang_deg")}};

    PropertySection accuracy{Text::tr("Accuracy"), {}};
    accuracy.specs = {
        {.path = QStringLiteral("process.contact_travel_cells"),
         .label = Text::tr("Step"),
         .help = Text::tr("How far the contact line travels in one step, in cells of the film. "
                          "Smaller is finer and slower."),
         .unit = Unit::Cells,
         .relevant = isProduction},
        {.path = QStringLiteral("process.time_step_s"),
         .label = Text::tr("Time step"),
         .help = Text::tr("Time that one step simulates."),
         .unit = Unit::Time,
         .relevant = isPaperModel},
        {.path = QStringLiteral("process.iterations"),
         .label = Text::tr("Iterations"),
         .help = Text::tr("Sweeps over all constraints in one step."),
         .relevant = isPaperModel},
        {.path = QStringLiteral("process.relaxation"),
         .label = Text::tr("Sweeps"),
         .help = Text::tr("Jacobi corrects all points at once and averages; Gauss–Seidel one after "
                          "the other."),
         .words = {{QStringLiteral("jacobi"), QStringLiteral("Jacobi")},
                   {QStringLiteral("gauss-seidel"), QStringLiteral("Gauss–Seidel")}},
         .relevant = isPaperModel},
        {.path = QStringLiteral("process.self_contact"),
         .label = Text::tr("Self-contact"),
         .help = Text::tr("Keep film from passing through film."),
         .relevant = isPaperModel}};
    return {motion, limits, accuracy, cradleProperties()};
}

std::vector<PropertySection> immersionProperties(std::size_t number) {
    const QString prefix = QStringLiteral("immersions[%1].").arg(number);
    return {{{},
             {{.path = prefix + QStringLiteral("name"),
               .label = Text::tr("Name"),
               .help = Text::tr("What this immersion is called. It stands in the job line of its "
                                "sheet.")},
              {.path = prefix + QStringLiteral("rotation_deg"),
               .label = Text::tr("Rotation"),
               .help = Text::tr("How the body is turned about X, then Y, then Z before it is "
                                "dipped. Drag the rings in the view to turn it by hand; hold Shift "
                                "for steps of 15°."),
               .unit = Unit::Angle,
               .parts = {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")}},
              {.path = prefix + QStringLiteral("offset_mm"),
               .label = Text::tr("Offset"),
               .help = Text::tr("Where the body meets the film, from the middle of the film: X to "
                                "the right, Z down the sheet."),
               .unit = Unit::Length,
               .parts = {QStringLiteral("X"), QStringLiteral("Z")}}}}};
}

std::vector<PropertySection> shareProperties() {
    const auto isShared = [](const Project& project) { return project.share.enabled; };
    return {{{},
             {{.path = QStringLiteral("share.enabled"),
               .label = Text::tr("Split the body between the dips"),
               .help = Text::tr("Each dip paints the places that it paints better, and leaves the "
                                "others blank. If not, both paint all that they reach, and some "
                                "places are painted twice.")},
              {.path = QStringLiteral("share.overlap_mm"),
               .label = Text::tr("Overlap"),
               .help = Text::tr("The band along the join in which both dips fade into each other, "
                                "on the body. It is made wider where the registration error would "
                                "show in it."),
               .unit = Unit::Length,
               .relevant = isShared},
              {.path = QStringLiteral("share.registration_error_mm"),
               .label = Text::tr("Registration error"),
               .help = Text::tr("How far the second dip may lie off the first. The band is made "
                                "wide enough that no edge shows."),
               .unit = Unit::Length,
               .relevant = isShared},
              {.path = QStringLiteral("share.stretch_limit"),
               .label = Text::tr("Stretched by at most"),
               .help = Text::tr("Where one dip's film is drawn out to more times its length, the "
                                "other is to paint, if it can."),
               .unit = Unit::Ratio,
               .relevant = isShared}}}};
}

PropertySection pageProperties() {
    PropertySection page{Text::tr("Page"), {}};
    page.specs = {
        {.path = QStringLiteral("sheet.paper"),
         .label = Text::tr("Paper"),
         .help = Text::tr("The page that the film image is laid on. “As the film” prints the film "
                          "itself, edge to edge."),
         .words = {{QStringLiteral("film"), Text::tr("As the film")},
                   {QStringLiteral("custom"), Text::tr("Custom")}}},
        {.path = QStringLiteral("sheet.custom_size_mm"),
         .label = Text::tr("Size"),
         .help = Text::tr("Width and height of the page."),
         .unit = Unit::Length,
         .parts = {Text::tr("W", "width"), Text::tr("H", "height")},
         .relevant = [](const Project& p) { return p.sheet.paper == QLatin1String("custom"); }},
        {.path = QStringLiteral("sheet.landscape"),
         .label = Text::tr("Landscape"),
         .help = Text::tr("Turn the page on its side."),
         .relevant = [](const Project& p) { return p.sheet.paper != QLatin1String("film"); }},
        {.path = QStringLiteral("sheet.dpi"),
         .label = Text::tr("Resolution"),
         .help = Text::tr("Pixels to the inch of the film image."),
         .unit = Unit::Resolution},
        {.path = QStringLiteral("sheet.bleed_mm"),
         .label = Text::tr("Bleed"),
         .help = Text::tr("How far the colour is continued past the painted area, so that a small "
                          "error of position leaves no bare edge."),
         .unit = Unit::Length}};
    return page;
}

PropertySection onPageProperties() {
    PropertySection extras{Text::tr("On the page"), {}};
    extras.specs = {
        {.path = QStringLiteral("sheet.marks"),
         .label = Text::tr("Registration marks"),
         .help = Text::tr("Marks in the corners by which the film is laid into the tank.")},
        {.path = QStringLiteral("sheet.ruler"),
         .label = Text::tr("Ruler"),
         .help = Text::tr("A ruler of 100 mm: measure it to see that the page was printed at true "
                          "size.")},
        {.path = QStringLiteral("sheet.job_line"),
         .label = Text::tr("Job line"),
         .help = Text::tr("A line with project, immersion, date, film, scale and a check sum.")}};
    return extras;
}

std::vector<PropertySpec> whiteProperties() {
    const auto isWhite = [](const Project& p) { return p.sheet.white != WhiteLayer::None; };
    return {
        {.path = QStringLiteral("body.base_colour"),
         .label = Text::tr("Part's colour"),
         .help = Text::tr("Of the bare part, as #1a2b3c: proof and view show the ink on it. "
                          "Empty: light grey, and ink as it looks on white."),
         .isColour = true},
        {.path = QStringLiteral("sheet.white"),
         .label = Text::tr("White"),
         .help = Text::tr("A plate of white under all colour. What is printed last touches the "
                          "part; printed first, it lies on the outside, over the colour. In PDF "
                          "and TIFF in CMYK."),
         .words = {{QStringLiteral("none"), Text::tr("None")},
                   {QStringLiteral("last"), Text::tr("Printed last, under the colour")},
                   {QStringLiteral("first"), Text::tr("Printed first, over the colour")}}},
        {.path = QStringLiteral("sheet.white_density"),
         .label = Text::tr("Density"),
         .help = Text::tr("Share of full tint that the part is to have; more is printed where the "
                          "film stretches, as far as full tint goes."),
         .unit = Unit::Share,
         .relevant = isWhite},
        {.path = QStringLiteral("sheet.white_choke_mm"),
         .label = Text::tr("Choke"),
         .help = Text::tr("How much smaller than the colour the white is, all round, on the film."),
         .unit = Unit::Length,
         .relevant = isWhite},
        {.path = QStringLiteral("sheet.white_name"),
         .label = Text::tr("Name of white"),
         .help = Text::tr("The name by which the printer knows its white ink."),
         .relevant = isWhite}};
}

std::vector<PropertySpec> cutLineProperties() {
    const auto cutsInk = [](const Project& p) { return p.sheet.cutLine == CutLine::Ink; };
    const auto cuts = [](const Project& p) { return p.sheet.cutLine != CutLine::None; };
    return {
        {.path = QStringLiteral("sheet.cut_line"),
         .label = Text::tr("Cut line"),
         .help = Text::tr("A line for the cutter, as a spot ink in a PDF in CMYK."),
         .words = {{QStringLiteral("none"), Text::tr("None")},
                   {QStringLiteral("ink"), Text::tr("Round the ink")},
                   {QStringLiteral("film"), Text::tr("Along the film's edge")}}},
        {.path = QStringLiteral("sheet.cut_distance_mm"),
         .label = Text::tr("Distance"),
         .help = Text::tr("Of the cut line from the ink."),
         .unit = Unit::Length,
         .relevant = cutsInk},
        {.path = QStringLiteral("sheet.cut_bleed_mm"),
         .label = Text::tr("Bleed past it"),
         .help = Text::tr("How far beyond the cut line the colours of the painted film's edge go "
                          "on, so that a cut that slips shows no bare film."),
         .unit = Unit::Length,
         .relevant = cutsInk},
        {.path = QStringLiteral("sheet.cut_name"),
         .label = Text::tr("Its ink"),
         .help = Text::tr("The name by which the cutter knows the line."),
         .relevant = cuts}};
}

PropertySection correctionProperties() {
    PropertySection correction{Text::tr("Correction"), {}};
    correction.specs = {
        {.path = QStringLiteral("as_built.correct"),
         .label = Text::tr("By what repeats"),
         .help = Text::tr("Takes off the sheet what the parts that the job keeps are off again and "
                          "again."),
         .relevant = [](const Project& p) { return !p.asBuilt.parts.empty(); }},
        {.path = QStringLiteral("as_built.strength"),
         .label = Text::tr("Strength"),
         .help = Text::tr("How much of it is taken off."),
         .unit = Unit::Share,
         .relevant = [](const Project& p) { return !p.asBuilt.parts.empty(); }}};
    return correction;
}

std::vector<PropertySection> sheetProperties() {
    PropertySection spots{Text::tr("Spot inks"), whiteProperties()};
    const std::vector<PropertySpec> cutLine = cutLineProperties();
    spots.specs.insert(spots.specs.end(), cutLine.begin(), cutLine.end());
    return {pageProperties(), onPageProperties(), spots, correctionProperties()};
}

std::vector<PropertySection> inkProperties() {
    return {
        {{},
         {{.path = QStringLiteral("ink.compensate"),
           .label = Text::tr("Compensate stretch"),
           .help = Text::tr("Ink thins where the film stretches. Print more there, so that the "
                            "body shows the colour of the texture.")},
          {.path = QStringLiteral("ink.limit"),
           .label = Text::tr("Ink limit"),
           .help = Text::tr("The highest optical density that can be printed. Where more would "
                            "be needed, the colour falls short and the report says so."),
           .unit = Unit::Density},
          specOf(QStringLiteral("ink.exponents"), materialWords(QStringLiteral("ink_exponents"))),
          specOf(QStringLiteral("ink.black_white_exponents"),
                 materialWords(QStringLiteral("ink_black_white_exponents"))),
          specOf(QStringLiteral("ink.tones"), materialWords(QStringLiteral("ink_tones")))}}};
}

PropertySection offProperties() {
    const QString x = QStringLiteral("X"), y = QStringLiteral("Y"), z = QStringLiteral("Z");
    PropertySection off{Text::tr("Expected deviations (±)"), {}};
    off.specs = {
        {.path = QStringLiteral("tolerance.position_mm"),
         .label = Text::tr("Body on the water"),
         .help = Text::tr("How far the body may lie off its place when it meets the film. 95 of "
                          "100 dips keep a tolerance."),
         .unit = Unit::Length,
         .parts = {x, z}},
        {.path = QStringLiteral("tolerance.turn_deg"),
         .label = Text::tr("Body turned"),
         .help = Text::tr("How far the body may be turned off its pose, about axes through its "
                          "middle."),
         .unit = Unit::Angle,
         .parts = {x, y, z}},
        {.path = QStringLiteral("tolerance.film_position_mm"),
         .label = Text::tr("Film on the water"),
         .help = Text::tr("How far the film may lie off its place when the body meets it."),
         .unit = Unit::Length,
         .parts = {x, z}},
        {.path = QStringLiteral("tolerance.film_turn_deg"),
         .label = Text::tr("Film turned"),
         .help = Text::tr("How far the film may be turned on the water, about its middle."),
         .unit = Unit::Angle},
        {.path = QStringLiteral("tolerance.swell"),
         .label = Text::tr("Swell"),
         .help = Text::tr("By how much of its length the floating film may be longer or shorter "
                          "than reckoned."),
         .unit = Unit::Share},
        {.path = QStringLiteral("tolerance.water_level_mm"),
         .label = Text::tr("Water level"),
         .help = Text::tr("By how much the body may go under deeper or less deep."),
         .unit = Unit::Length},
        {.path = QStringLiteral("tolerance.speed"),
         .label = Text::tr("Speed"),
         .help = Text::tr("By how much of its speed the dip may be faster or slower."),
         .unit = Unit::Share},
        {.path = QStringLiteral("tolerance.relaxation"),
         .label = Text::tr("Relaxation"),
         .help = Text::tr("By how much of it the film's relaxation time may be longer or shorter."),
         .unit = Unit::Share}};
    return off;
}

PropertySection verdictProperties() {
    const QMap<QString, QString> advice{{QStringLiteral("print"), Text::tr("Print it")},
                                        {QStringLiteral("look_first"), Text::tr("Check first")},
                                        {QStringLiteral("do_not_print"), Text::tr("Do not print")}};
    const auto spec = [](const char* path, const QString& label, const QString& help) {
        return PropertySpec{
            .path = QLatin1String(path), .label = label, .help = help, .unit = Unit::Share};
    };
    PropertySection verdict{Text::tr("Verdict: check first above"), {}};
    verdict.specs = {
        spec("verdict.air", Text::tr("Trapped air"),
             Text::tr("The share of the body's surface that trapped air may keep dry. The verdict "
                      "is “do not print” above five times a limit.")),
        spec("verdict.pale", Text::tr("Too pale"),
             Text::tr("The share of the painted area that may look too pale, because the film "
                      "stretches more than the ink can make up for.")),
        spec("verdict.damaged", Text::tr("Torn or released film"),
             Text::tr("The share of the painted area on which the film may tear or be pulled off "
                      "the body.")),
        spec("verdict.unreached", Text::tr("Reached by neither dip"),
             Text::tr("The share of the body's surface that neither of two dips may reach. A job "
                      "of one dip has no such limit.")),
        spec("verdict.narrow", Text::tr("Narrow overlap"),
             Text::tr("The share of the overlap of two dips that may be too narrow for how far "
                      "the second film may lie off.")),
        spec("verdict.zone_bare", Text::tr("Bare in a zone"),
             Text::tr("The share of zone A or B, where they are marked, that may stay without "
                      "paint.")),
        {.path = QStringLiteral("verdict.edge_mm"),
         .label = Text::tr("Film's edge"),
         .help = Text::tr("How far the painted film has to stay from the film's edge, so that it "
                          "neither curls nor folds."),
         .unit = Unit::Length},
        {.path = QStringLiteral("verdict.no_picture"),
         .label = Text::tr("No picture"),
         .help = Text::tr("What a model of one plain colour, without artwork, comes to."),
         .words = advice},
        {.path = QStringLiteral("verdict.changed_model"),
         .label = Text::tr("Repaired model"),
         .help = Text::tr("What a model comes to that was put right, or lacks something that its "
                          "file names."),
         .words = advice},
        {.path = QStringLiteral("verdict.guessed_film"),
         .label = Text::tr("Film not measured"),
         .help = Text::tr("What a film comes to whose swell nobody has measured."),
         .words = advice}};
    return verdict;
}

std::vector<PropertySection> toleranceProperties() {
    return {
        offProperties(),
        {Text::tr("Limits"),
         {{.path = QStringLiteral("tolerance.limits_mm"),
           .label = Text::tr("Of the zones"),
           .help = Text::tr("How far colours may land off their places, to either side. What "
                            "is not marked on the body is zone C."),
           .unit = Unit::Length,
           .parts = {QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C")}}}},
        verdictProperties(),
        {Text::tr("Check"),
         {{.path = QStringLiteral("tolerance.samples"),
           .label = Text::tr("Dips"),
           .help = Text::tr("Dips with everything off at once, to see whether what each does by "
                            "itself can be added up. 0: none.")},
          {.path = QStringLiteral("tolerance.seed"),
           .label = Text::tr("Seed"),
           .help = Text::tr("What is off by how much in them. Another number draws others.")}}}};
}

} // namespace

PropertySpec specOf(const QString& path, const FieldWords& words) {
    return {.path = path,
            .label = words.label,
            .help = words.help,
            .unit = words.unit,
            .parts = words.parts,
            .words = words.words,
            .absent = words.absent,
            .whenPresent = words.whenPresent,
            .linked = words.linked};
}

QString partName(const ProjectNode& node, const Project& project) {
    switch (node.part) {
    case ProjectPart::Project:
        return project.name;
    case ProjectPart::Model:
        return Text::tr("Model");
    case ProjectPart::Film:
        return Text::tr("Film");
    case ProjectPart::Process:
        return Text::tr("Dipping");
    case ProjectPart::Share:
        return Text::tr("Join");
    case ProjectPart::Sheet:
        return Text::tr("Sheet");
    case ProjectPart::Ink:
        return Text::tr("Ink");
    case ProjectPart::Tolerance:
        return Text::tr("Tolerances");
    case ProjectPart::Immersion:
        break;
    }
    return project.immersions[node.immersion].name;
}

std::vector<PropertySection> propertySections(const ProjectNode& node) {
    switch (node.part) {
    case ProjectPart::Project:
        return projectProperties();
    case ProjectPart::Model:
        return modelProperties();
    case ProjectPart::Film:
        return filmProperties();
    case ProjectPart::Process:
        return processProperties();
    case ProjectPart::Immersion:
        return immersionProperties(node.immersion);
    case ProjectPart::Share:
        return shareProperties();
    case ProjectPart::Sheet:
        return sheetProperties();
    case ProjectPart::Ink:
        return inkProperties();
    case ProjectPart::Tolerance:
        return toleranceProperties();
    }
    return {};
}

std::optional<ProjectNode> nodeOfField(const QString& path) {
    for (const ProjectPart part :
         {ProjectPart::Project, ProjectPart::Model, ProjectPart::Film, ProjectPart::Process,
          ProjectPart::Share, ProjectPart::Sheet, ProjectPart::Ink, ProjectPart::Tolerance}) {
        for (const PropertySection& section : propertySections({part})) {
            if (std::ranges::find(section.specs, path, &PropertySpec::path) !=
                section.specs.end()) {
                return ProjectNode{part};
            }
        }
    }
    return std::nullopt;
}

} // namespace dipwright
