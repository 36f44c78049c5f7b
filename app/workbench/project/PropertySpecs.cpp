#include "workbench/project/PropertySpecs.h"

#include "dip/FilmUnderBody.h"
#include "project/NewProject.h"

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

// `path` is relative to a film profile.
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
               .help = Text::tr(
                   "The name of the project. It is printed in the job line of every sheet.")},
              {.path = QStringLiteral("created"),
               .label = Text::tr("Date"),
               .help = Text::tr("The date in the job line. It is stored in the project, so that "
                                "the same project always gives the same sheet.")}}}};
}

std::vector<PropertySection> modelProperties() {
    return {{Text::tr("Distance field"),
             {{.path = QStringLiteral("body.sdf_resolution"),
               .label = Text::tr("Samples per edge"),
               .help = Text::tr(
                   "Number of samples along each edge of the distance field around the part. More "
                   "samples follow finer detail and take longer to compute.")}}}};
}

PropertySection printedFilmProperties() {
    PropertySection printed{Text::tr("Printed film"), {}};
    printed.specs = {
        {.path = QStringLiteral("film.preset"),
         .label = Text::tr("Format"),
         .help = Text::tr("The size of the film as it is delivered and printed."),
         .words = {{QStringLiteral("custom"), Text::tr("Custom")}}},
        {.path = QStringLiteral("film.size_mm"),
         .label = Text::tr("Size"),
         .help =
             Text::tr("Width (W) and height (H) of the printed film. The cells of the simulated "
                      "film keep their size."),
         .unit = Unit::Length,
         .parts = {Text::tr("W", "width"), Text::tr("H", "height")}},
        {.path = QStringLiteral("film.resolution"),
         .label = Text::tr("Resolution"),
         .help = Text::tr("How fine the simulated film is. “Automatic” chooses the cell size from "
                          "the part's narrow features and its pose: fine where the part enters the "
                          "film, coarse towards the film's edges."),
         .words = {{QStringLiteral("automatic"), Text::tr("Automatic")},
                   {QStringLiteral("cell"), Text::tr("Cell size")},
                   {QStringLiteral("points"), Text::tr("Number of points")}},
         .relevant = isProduction},
        {.path = QStringLiteral("film.cell_mm"),
         .label = Text::tr("Cells"),
         .help = Text::tr("Side length of the simulated film's cells where the part enters the "
                          "film. Smaller cells show finer detail and take longer."),
         .unit = Unit::Length,
         .relevant =
             [](const Project& project) {
                 return isProduction(project) && project.film.resolution == FilmResolution::Cell;
             }},
        {.path = QStringLiteral("film.work_million"),
         .label = Text::tr("Work limit"),
         .help =
             Text::tr("If the numerical error is too large to print a sheet, its dip is repeated "
                      "with smaller cells. This limits the work of one dip: the number of film "
                      "points times the number of steps, in millions. 100 takes about 20 s on two "
                      "cores. 0: the dip is not repeated."),
         .unit = Unit::Million,
         .relevant =
             [](const Project& project) {
                 return isProduction(project) &&
                        project.film.resolution == FilmResolution::Automatic;
             }},
        {.path = QStringLiteral("film.wanted_error_mm"),
         .label = Text::tr("Wanted error"),
         .help = Text::tr("The dip is repeated with smaller cells until the numerical error is at "
                          "most this on 95 % of the painted area, or until the work limit is "
                          "reached. “Printable”: only until the sheet can be printed."),
         .unit = Unit::Length,
         .absent = Text::tr("Printable"),
         .whenPresent = newProjectWantedError.value(),
         .relevant =
             [](const Project& project) {
                 return isProduction(project) && isRefinable(project.film);
             }},
        {.path = QStringLiteral("film.points"),
         .label = Text::tr("Points"),
         .help = Text::tr("Number of points of the simulated film, across (W) and down (H). More "
                          "points show finer detail and take longer."),
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
         .help =
             Text::tr("Isotropic film resists shear; the result does not depend on the direction "
                      "of the grid. The structural lattice connects each point only with its "
                      "horizontal and vertical neighbours, as in the publication of 2020."),
         .words = {{QStringLiteral("isotropic"), Text::tr("Isotropic")},
                   {QStringLiteral("structural"), Text::tr("Structural lattice")}}},
        {.path = QStringLiteral("film.support"),
         .label = Text::tr("Support"),
         .help = Text::tr(
             "Water: the water supports the floating film. None: nothing supports the film."),
         .words = {{QStringLiteral("water"), Text::tr("Water")},
                   {QStringLiteral("none"), Text::tr("None")}}}};

    return {printedFilmProperties(),
            floating,
            {Text::tr("Sides"),
             {material(film, "edges.left"), material(film, "edges.right"),
              material(film, "edges.top"), material(film, "edges.bottom")}},
            {Text::tr("Advanced: material laws that are not measured"),
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
               Text::tr("Gap between the cradle and the part that lies in it.")),
        length("cradle.wall_mm", Text::tr("Wall thickness"),
               Text::tr("The smallest thickness of the walls that hold the part.")),
        length("cradle.reach_mm", Text::tr("Reach"),
               Text::tr("How far below the top of the part the cradle reaches. It reaches deeper "
                        "where the part would tip or slide.")),
        length("cradle.paint_distance_mm", Text::tr("Distance to the film"),
               Text::tr("Smallest distance from the cradle to any place that the film reaches or "
                        "that earlier dips have painted.")),
        {.path = QStringLiteral("cradle.on_paint"),
         .label = Text::tr("Contact with paint"),
         .help = Text::tr("Whether the cradle may support the part on areas that earlier dips have "
                          "painted, with padding in between.")},
        {.path = QStringLiteral("cradle.padding_mm"),
         .label = Text::tr("Padding"),
         .help = Text::tr("Space for felt or foam where the cradle rests on paint."),
         .unit = Unit::Length,
         .relevant = isOnPaint},
        length("cradle.plate_thickness_mm", Text::tr("Plate thickness"),
               Text::tr("Thickness of the plate that the cradle hangs from.")),
        length("cradle.standoff_mm", Text::tr("Height above the water"),
               Text::tr("Height of the plate above the water at the end of the dip.")),
        length("cradle.pin_span_mm", Text::tr("Pin spacing"),
               Text::tr("Largest distance between two datum pins. The pins stand where the sheet's "
                        "marks float, or closer to the film's centre.")),
        length("cradle.pin_diameter_mm", Text::tr("Pin diameter"),
               Text::tr("Diameter of the datum pins on the tank's frame.")),
        length("cradle.pin_clearance_mm", Text::tr("Pin clearance"),
               Text::tr("Gap between a pin and its hole, all round.")),
        length("cradle.bore_mm", Text::tr("Bore"),
               Text::tr("Diameter of a hole through the cradle and its plate, for holding the part "
                        "with a screw, suction or hot glue. 0: no hole.")),
        length("cradle.engraving_mm", Text::tr("Engraving"),
               Text::tr("Depth of the engraved arrow, dip number and job number in the plate. 0: "
                        "no engraving.")),
        length("cradle.cell_mm", Text::tr("Cell size"),
               Text::tr("Side length of the cells on which the cradle is computed. Smaller cells "
                        "give a smoother surface, take longer and make larger files."))};
    return cradle;
}

std::vector<PropertySection> processProperties() {
    PropertySection motion{Text::tr("Motion"), {}};
    motion.specs = {
        {.path = QStringLiteral("process.dip_speed_mm_s"),
         .label = Text::tr("Speed"),
         .help = Text::tr("How fast the part moves down into the water. On a slanted path the "
                          "machine moves faster, because the part also travels sideways."),
         .unit = Unit::Speed},
        {.path = QStringLiteral("process.depth_mm"),
         .label = Text::tr("Depth"),
         .help = Text::tr("How far the lowest point of the part goes below the waterline. “Whole "
                          "part” dips until the part is fully under water."),
         .unit = Unit::Length,
         .absent = Text::tr("Whole part"),
         .whenPresent = 20},
        {.path = QStringLiteral("process.margin_mm"),
         .label = Text::tr("Extra depth"),
         .help = Text::tr("How much farther the part moves down once it is fully under water."),
         .unit = Unit::Length,
         .relevant = [](const Project& project) { return !project.process.depth; }}};

    const QString process = QStringLiteral("process.");
    const PropertySection limits{
        Text::tr("Limits"), {material(process, "tear_stretch"), material(process, "overhang_deg")}};

    PropertySection accuracy{Text::tr("Accuracy"), {}};
    accuracy.specs = {
        {.path = QStringLiteral("process.contact_travel_cells"),
         .label = Text::tr("Step"),
         .help = Text::tr("How far the contact line moves in one step, in cells of the film. For "
                          "a more exact sheet, smaller cells are better than steps below 0.5."),
         .unit = Unit::Cells,
         .relevant = isProduction},
        {.path = QStringLiteral("process.time_step_s"),
         .label = Text::tr("Time step"),
         .help = Text::tr("The simulated time of one step."),
         .unit = Unit::Time,
         .relevant = isPaperModel},
        {.path = QStringLiteral("process.iterations"),
         .label = Text::tr("Iterations"),
         .help = Text::tr("Number of sweeps over all constraints in one step."),
         .relevant = isPaperModel},
        {.path = QStringLiteral("process.relaxation"),
         .label = Text::tr("Sweep method"),
         .help = Text::tr("Jacobi corrects all points at once and averages the corrections. "
                          "Gauss–Seidel corrects one point after the other."),
         .words = {{QStringLiteral("jacobi"), QStringLiteral("Jacobi")},
                   {QStringLiteral("gauss-seidel"), Text::tr("Gauss–Seidel")}},
         .relevant = isPaperModel},
        {.path = QStringLiteral("process.self_contact"),
         .label = Text::tr("Self-contact"),
         .help = Text::tr("Prevents the film from passing through itself."),
         .relevant = isPaperModel}};
    return {motion, limits, accuracy, cradleProperties()};
}

namespace {

PropertySection pathProperties(std::size_t number) {
    const QString prefix = QStringLiteral("immersions[%1].path.").arg(number);
    const auto ifPath = [number](bool (*holds)(const DipPath&)) {
        return [number, holds](const Project& project) {
            return number < project.immersions.size() && holds(project.immersions[number].path);
        };
    };
    const auto isPreset = ifPath([](const DipPath& path) { return path.kind != PathKind::Poses; });
    return {
        Text::tr("Path"),
        {{.path = prefix + QStringLiteral("kind"),
          .label = Text::tr("Path"),
          .help =
              Text::tr("How the part moves into the water. Slanted: down and sideways. Tilt: "
                       "one side enters first, and the part is levelled while it goes down. "
                       "Roll: down to the depth of the dip, then rolled sideways over the film; "
                       "set a depth (Dipping > Depth) at which the part is not yet under water. "
                       "Poses: through poses that you set; at first they follow the present "
                       "path. "
                       "The rotation above is the part's rotation at the end of the dip."),
          .words = {{QStringLiteral("straight"), Text::tr("Straight down")},
                    {QStringLiteral("slanted"), Text::tr("Slanted")},
                    {QStringLiteral("tilt"), Text::tr("Tilt in and level")},
                    {QStringLiteral("roll"), Text::tr("Roll")},
                    {QStringLiteral("poses"), Text::tr("Through poses")}}},
         {.path = prefix + QStringLiteral("angle_deg"),
          .label = Text::tr("Angle"),
          .help =
              Text::tr("Slanted: the angle between the path and the water, 10° to 170°. Tilt: how "
                       "far the part is tilted when the dip begins, at most 85°. Roll: the angle "
                       "through which it rolls. Slanted above 90°, or a negative tilt or roll, is "
                       "against the heading."),
          .unit = Unit::Angle,
          .relevant = ifPath([](const DipPath& path) {
              return path.kind != PathKind::Straight && path.kind != PathKind::Poses;
          })},
         {.path = prefix + QStringLiteral("heading_deg"),
          .label = Text::tr("Heading"),
          .help = Text::tr("The direction on the water in which the part travels or rolls, or the "
                           "side that enters first. 0°: to the right (X), 90°: down the sheet "
                           "(Z). The water flows in this direction, too."),
          .unit = Unit::Angle,
          .relevant = ifPath([](const DipPath& path) {
              return (path.kind != PathKind::Straight && path.kind != PathKind::Poses) ||
                     path.waterSpeed != MillimetresPerSecond(0);
          })},
         {.path = prefix + QStringLiteral("level_depth_mm"),
          .label = Text::tr("Level at"),
          .help = Text::tr("Depth of the part's lowest point at which the part is no longer "
                           "tilted."),
          .unit = Unit::Length,
          .absent = Text::tr("The end of the dip"),
          .whenPresent = 20,
          .relevant = ifPath([](const DipPath& path) { return path.kind == PathKind::Tilt; })},
         {.path = prefix + QStringLiteral("roll_radius_mm"),
          .label = Text::tr("Rolling radius"),
          .help = Text::tr("How far the part travels sideways while it rolls through one radian "
                           "(57.3°). Half the part's height lets a cylinder roll without slip."),
          .unit = Unit::Length,
          .absent = Text::tr("Half the part's height"),
          .whenPresent = 20,
          .relevant = ifPath([](const DipPath& path) { return path.kind == PathKind::Roll; })},
         {.path = prefix + QStringLiteral("turn_deg"),
          .label = Text::tr("Turn"),
          .help =
              Text::tr("Turn about the vertical while the part goes down, counterclockwise seen "
                       "from above."),
          .unit = Unit::Angle,
          .relevant = isPreset},
         {.path = prefix + QStringLiteral("water_speed_mm_s"),
          .label = Text::tr("Water speed"),
          .help = Text::tr("Speed at which water and film flow through the tank, in the direction "
                           "of the heading. A negative speed flows against the heading."),
          .unit = Unit::Speed},
         {.path = prefix + QStringLiteral("slow_speed_mm_s"),
          .label = Text::tr("Slow speed"),
          .help = Text::tr("Speed on the first and the last part of the way down. If the part then "
                           "rolls, it rolls at the speed of the dip."),
          .unit = Unit::Speed,
          .absent = Text::tr("Same as the dip"),
          .whenPresent = 2,
          .relevant = isPreset},
         {.path = prefix + QStringLiteral("slow_mm"),
          .label = Text::tr("Slow distance"),
          .help = Text::tr(
              "The slow speed applies to the first and the last part of the way down. This is "
              "the length of each part."),
          .unit = Unit::Length,
          .relevant = ifPath([](const DipPath& path) {
              return path.slowSpeed.has_value() && path.kind != PathKind::Poses;
          })},
         {.path = prefix + QStringLiteral("acceleration_mm_s2"),
          .label = Text::tr("Acceleration"),
          .help = Text::tr("The acceleration with which the part reaches its speed on the path and "
                           "stops. The dip takes longer than without a limit."),
          .unit = Unit::Acceleration,
          .absent = Text::tr("No limit"),
          .whenPresent = 50}}};
}

} // namespace

std::vector<PropertySection> immersionProperties(std::size_t number) {
    const QString prefix = QStringLiteral("immersions[%1].").arg(number);
    return {
        {{},
         {{.path = prefix + QStringLiteral("name"),
           .label = Text::tr("Name"),
           .help = Text::tr("The name of this dip. It is printed in the job line of its sheet.")},
          {.path = prefix + QStringLiteral("rotation_deg"),
           .label = Text::tr("Rotation"),
           .help =
               Text::tr("Rotation of the part about X, then Y, then Z. If the part tilts, rolls "
                        "or turns on its path: its rotation at the end of the dip. You can "
                        "also drag the rings in the view; hold Shift for steps of 15°."),
           .unit = Unit::Angle,
           .parts = {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")}},
          {.path = prefix + QStringLiteral("offset_mm"),
           .label = Text::tr("Offset"),
           .help =
               Text::tr("Where the centre of the part is when the dip begins, measured from the "
                        "film's centre: X to the right, Z down the sheet."),
           .unit = Unit::Length,
           .parts = {QStringLiteral("X"), QStringLiteral("Z")}}}},
        pathProperties(number)};
}

std::vector<PropertySection> shareProperties() {
    const auto isShared = [](const Project& project) { return project.share.enabled; };
    return {
        {{},
         {{.path = QStringLiteral("share.enabled"),
           .label = Text::tr("Split the part between the dips"),
           .help = Text::tr("Each dip paints the areas where it gives the better result and leaves "
                            "the others blank. If off, both dips paint everything they reach, and "
                            "some areas are painted twice.")},
          {.path = QStringLiteral("share.overlap_mm"),
           .label = Text::tr("Overlap"),
           .help = Text::tr(
               "Width, on the part, of the band along the seam that both dips paint. The dips fade "
               "into each other there. The band is wider where the registration error would show."),
           .unit = Unit::Length,
           .relevant = isShared},
          {.path = QStringLiteral("share.registration_error_mm"),
           .label = Text::tr("Registration error"),
           .help = Text::tr("How far the second dip may be displaced from the first. The overlap "
                            "is made wide enough that no edge shows."),
           .unit = Unit::Length,
           .relevant = isShared},
          {.path = QStringLiteral("share.stretch_limit"),
           .label = Text::tr("Stretch limit"),
           .help = Text::tr("Where the film of one dip stretches beyond this factor, the other dip "
                            "paints if it can."),
           .unit = Unit::Ratio,
           .relevant = isShared}}}};
}

PropertySection pageProperties() {
    PropertySection page{Text::tr("Page"), {}};
    page.specs = {
        {.path = QStringLiteral("sheet.paper"),
         .label = Text::tr("Paper"),
         .help = Text::tr("The page that the film image is placed on. “Same as the film” prints "
                          "the film itself, edge to edge."),
         .words = {{QStringLiteral("film"), Text::tr("Same as the film")},
                   {QStringLiteral("custom"), Text::tr("Custom")}}},
        {.path = QStringLiteral("sheet.custom_size_mm"),
         .label = Text::tr("Size"),
         .help = Text::tr("Width (W) and height (H) of the page."),
         .unit = Unit::Length,
         .parts = {Text::tr("W", "width"), Text::tr("H", "height")},
         .relevant = [](const Project& p) { return p.sheet.paper == QLatin1String("custom"); }},
        {.path = QStringLiteral("sheet.landscape"),
         .label = Text::tr("Landscape"),
         .help = Text::tr("Turns the page on its side."),
         .relevant = [](const Project& p) { return p.sheet.paper != QLatin1String("film"); }},
        {.path = QStringLiteral("sheet.dpi"),
         .label = Text::tr("Resolution"),
         .help = Text::tr("Pixels per inch of the film image."),
         .unit = Unit::Resolution},
        {.path = QStringLiteral("sheet.bleed_mm"),
         .label = Text::tr("Bleed"),
         .help = Text::tr("How far the colour continues beyond the painted area, so that a small "
                          "position error leaves no bare edge."),
         .unit = Unit::Length}};
    return page;
}

PropertySection onPageProperties() {
    PropertySection extras{Text::tr("Marks and text"), {}};
    extras.specs = {
        {.path = QStringLiteral("sheet.marks"),
         .label = Text::tr("Registration marks"),
         .help = Text::tr("Marks in the corners, for aligning the film in the tank.")},
        {.path = QStringLiteral("sheet.ruler"),
         .label = Text::tr("Ruler"),
         .help = Text::tr(
             "A ruler of 100 mm. Measure it to check that the page was printed at true size.")},
        {.path = QStringLiteral("sheet.job_line"),
         .label = Text::tr("Job line"),
         .help = Text::tr("A line with project, dip, date, film, scale and a checksum.")}};
    return extras;
}

std::vector<PropertySpec> whiteProperties() {
    const auto isWhite = [](const Project& p) { return p.sheet.white != WhiteLayer::None; };
    return {{.path = QStringLiteral("body.base_colour"),
             .label = Text::tr("Part colour"),
             .help = Text::tr(
                 "Colour of the bare part, such as #1a2b3c. Proof and view show the ink on this "
                 "colour. If empty, they show a light grey part, with the ink in the colours that "
                 "it has on white."),
             .isColour = true},
            {.path = QStringLiteral("sheet.white"),
             .label = Text::tr("White"),
             .help = Text::tr("A plate of white ink. White that is printed last touches the part, "
                              "under the colours. White that is printed first lies outside, over "
                              "the colours. Only in CMYK files (PDF and TIFF)."),
             .words = {{QStringLiteral("none"), Text::tr("None")},
                       {QStringLiteral("last"), Text::tr("Printed last, under the colour")},
                       {QStringLiteral("first"), Text::tr("Printed first, over the colour")}}},
            {.path = QStringLiteral("sheet.white_density"),
             .label = Text::tr("Density"),
             .help = Text::tr("How dense the white is on the finished part; 100 % is solid white. "
                              "Where the film stretches, more white is printed, up to 100 %."),
             .unit = Unit::Share,
             .relevant = isWhite},
            {.path = QStringLiteral("sheet.white_choke_mm"),
             .label = Text::tr("Choke"),
             .help = Text::tr(
                 "How far the edge of the white stays inside the edge of the colour, on the film."),
             .unit = Unit::Length,
             .relevant = isWhite},
            {.path = QStringLiteral("sheet.white_name"),
             .label = Text::tr("Name of the white ink"),
             .help = Text::tr("The name of the white ink in the printer."),
             .relevant = isWhite}};
}

std::vector<PropertySpec> cutLineProperties() {
    const auto cutsInk = [](const Project& p) { return p.sheet.cutLine == CutLine::Ink; };
    const auto cuts = [](const Project& p) { return p.sheet.cutLine != CutLine::None; };
    return {{.path = QStringLiteral("sheet.cut_line"),
             .label = Text::tr("Cut contour"),
             .help = Text::tr("The line that the cutter follows, as a spot colour in a CMYK PDF."),
             .words = {{QStringLiteral("none"), Text::tr("None")},
                       {QStringLiteral("ink"), Text::tr("Around the ink")},
                       {QStringLiteral("film"), Text::tr("Along the film's edge")}}},
            {.path = QStringLiteral("sheet.cut_distance_mm"),
             .label = Text::tr("Distance"),
             .help = Text::tr("Distance from the ink to the cut contour."),
             .unit = Unit::Length,
             .relevant = cutsInk},
            {.path = QStringLiteral("sheet.cut_bleed_mm"),
             .label = Text::tr("Bleed at the contour"),
             .help = Text::tr("How far the colours continue beyond the cut contour, so that a "
                              "misplaced cut shows no bare film."),
             .unit = Unit::Length,
             .relevant = cutsInk},
            {.path = QStringLiteral("sheet.cut_name"),
             .label = Text::tr("Contour name"),
             .help = Text::tr("The name of the spot colour that the cutter follows."),
             .relevant = cuts}};
}

PropertySection correctionProperties() {
    PropertySection correction{Text::tr("Correction"), {}};
    correction.specs = {{.path = QStringLiteral("as_built.correct"),
                         .label = Text::tr("Correct repeating errors"),
                         .help = Text::tr("Shifts the image on the sheet so that it cancels the "
                                          "error that repeats on the measured parts."),
                         .relevant = [](const Project& p) { return !p.asBuilt.parts.empty(); }},
                        {.path = QStringLiteral("as_built.strength"),
                         .label = Text::tr("Strength"),
                         .help = Text::tr("How much of the repeating error is corrected."),
                         .unit = Unit::Share,
                         .relevant = [](const Project& p) { return !p.asBuilt.parts.empty(); }}};
    return correction;
}

PropertySection orderProperties() {
    PropertySection order{Text::tr("Order"), {}};
    order.specs = {{.path = QStringLiteral("order.parts"),
                    .label = Text::tr("Parts to make"),
                    .help = Text::tr("The number of good parts that are ordered. Report, queue and "
                                     "traveller give the cost and the time of the order. Sheets do "
                                     "not depend on it.")}};
    return order;
}

std::vector<PropertySection> sheetProperties() {
    PropertySection spots{Text::tr("Spot colours"), whiteProperties()};
    const std::vector<PropertySpec> cutLine = cutLineProperties();
    spots.specs.insert(spots.specs.end(), cutLine.begin(), cutLine.end());
    return {pageProperties(), onPageProperties(), spots, correctionProperties(), orderProperties()};
}

std::vector<PropertySection> inkProperties() {
    return {
        {{},
         {{.path = QStringLiteral("ink.compensate"),
           .label = Text::tr("Compensate stretch"),
           .help = Text::tr("Ink thins where the film stretches. This prints more ink there, so "
                            "that the part shows the colour of the texture.")},
          {.path = QStringLiteral("ink.limit"),
           .label = Text::tr("Ink limit"),
           .help = Text::tr("The highest optical density that can be printed. Where more is "
                            "needed, the colour is too pale; the report gives the area."),
           .unit = Unit::Density},
          {.path = QStringLiteral("ink.densest"),
           .label = Text::tr("Densest colour"),
           .help = Text::tr("A tone curve lightens the darkest colours of the texture to this "
                            "density and keeps them apart, so that the ink suffices on stretched "
                            "film. Usual: 0.8 to 1.8. At 10 the texture stays as it is. The "
                            "amounts of ink of CMYK pictures do not change."),
           .unit = Unit::Density},
          {.path = QStringLiteral("ink.passes"),
           .label = Text::tr("Passes of ink"),
           .help = Text::tr("How many times the printer prints each sheet onto the same film. Two "
                            "passes reach twice the ink limit. The film must not move between "
                            "the passes, and takes longer to dry. Usual: 1.")},
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
         .label = Text::tr("Part position"),
         .help = Text::tr("How far the part may be from its intended place when it meets the film. "
                          "95 of 100 dips are within this distance."),
         .unit = Unit::Length,
         .parts = {x, z}},
        {.path = QStringLiteral("tolerance.turn_deg"),
         .label = Text::tr("Part rotation"),
         .help = Text::tr(
             "How far the part may be rotated from its pose, about axes through its centre."),
         .unit = Unit::Angle,
         .parts = {x, y, z}},
        {.path = QStringLiteral("tolerance.film_position_mm"),
         .label = Text::tr("Film position"),
         .help =
             Text::tr("How far the film may be from its intended place when the part meets it."),
         .unit = Unit::Length,
         .parts = {x, z}},
        {.path = QStringLiteral("tolerance.film_turn_deg"),
         .label = Text::tr("Film rotation"),
         .help = Text::tr("How far the film may be rotated on the water, about its centre."),
         .unit = Unit::Angle},
        {.path = QStringLiteral("tolerance.swell"),
         .label = Text::tr("Swell"),
         .help = Text::tr("How much longer or shorter than assumed the floating film may be, as a "
                          "share of its length."),
         .unit = Unit::Share},
        {.path = QStringLiteral("tolerance.water_level_mm"),
         .label = Text::tr("Water level"),
         .help = Text::tr("How much higher or lower than intended the water may stand. The part is "
                          "then dipped deeper or less deep."),
         .unit = Unit::Length},
        {.path = QStringLiteral("tolerance.speed"),
         .label = Text::tr("Speed"),
         .help = Text::tr("How much faster or slower the dip may be, as a share of the set speed."),
         .unit = Unit::Share},
        {.path = QStringLiteral("tolerance.relaxation"),
         .label = Text::tr("Relaxation"),
         .help = Text::tr("How much longer or shorter the film's relaxation time may be, as a "
                          "share of the relaxation time."),
         .unit = Unit::Share},
        {.path = QStringLiteral("tolerance.path_angle_deg"),
         .label = Text::tr("Path angle"),
         .help = Text::tr("How far the angle of a slanted, tilted or rolling dip may be from its "
                          "set value. Has no effect on other dips."),
         .unit = Unit::Angle},
        {.path = QStringLiteral("tolerance.timing_s"),
         .label = Text::tr("Start of the dip"),
         .help = Text::tr("How much earlier or later than intended the dip may begin. Has an "
                          "effect only if the water flows or the film grows."),
         .unit = Unit::Time}};
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
    PropertySection verdict{Text::tr("Limits beyond which the verdict is “check first”"), {}};
    verdict.specs = {
        spec("verdict.air", Text::tr("Trapped air"),
             Text::tr("The share of the part's surface that trapped air may keep dry. Above five "
                      "times any of these limits, the verdict is “do not print”.")),
        spec("verdict.pale", Text::tr("Too pale"),
             Text::tr("The share of the painted area that may be too pale because the film "
                      "stretches more than the ink can compensate.")),
        spec("verdict.damaged", Text::tr("Torn or released film"),
             Text::tr("The share of the painted area where the film may tear or be released from "
                      "the part.")),
        spec("verdict.unreached", Text::tr("Reached by neither dip"),
             Text::tr("The share of the part's surface that both dips may leave unreached. A job "
                      "with one dip has no such limit.")),
        spec("verdict.narrow", Text::tr("Narrow overlap"),
             Text::tr("The share of the overlap that may be too narrow for the registration error "
                      "of the second film.")),
        spec("verdict.zone_bare", Text::tr("Unpainted in a zone"),
             Text::tr("The share of a marked zone A or B that may stay unpainted.")),
        spec("verdict.least_painted", Text::tr("Least painted area"),
             Text::tr("The share of the part's surface that the only dip of a job should paint.")),
        {.path = QStringLiteral("verdict.edge_mm"),
         .label = Text::tr("Distance to film's edge"),
         .help = Text::tr("The smallest allowed distance between film that paints and the film's "
                          "edge. Nearer to the edge, film may curl or fold."),
         .unit = Unit::Length},
        {.path = QStringLiteral("verdict.no_picture"),
         .label = Text::tr("No texture or artwork"),
         .help = Text::tr("The verdict for a model of one plain colour without artwork."),
         .words = advice},
        {.path = QStringLiteral("verdict.changed_model"),
         .label = Text::tr("Repaired model"),
         .help = Text::tr("The verdict for a model that was repaired."),
         .words = advice},
        {.path = QStringLiteral("verdict.incomplete_model"),
         .label = Text::tr("Incomplete model"),
         .help = Text::tr("The verdict for a model of which the import left something out, such as "
                          "a missing texture or a texture transform."),
         .words = advice},
        {.path = QStringLiteral("verdict.guessed_film"),
         .label = Text::tr("Film not measured"),
         .help = Text::tr("The verdict for a film whose swell was not measured."),
         .words = advice},
        {.path = QStringLiteral("verdict.expired_film"),
         .label = Text::tr("Film expired"),
         .help = Text::tr("The verdict for a film whose profile gives an expiry date in the past."),
         .words = advice}};
    return verdict;
}

std::vector<PropertySection> toleranceProperties() {
    return {offProperties(),
            {Text::tr("Limits"),
             {{.path = QStringLiteral("tolerance.limits_mm"),
               .label = Text::tr("Zones"),
               .help = Text::tr("How far (±) colours may land from their intended places. Surface "
                                "that is not marked is zone C."),
               .unit = Unit::Length,
               .parts = {QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C")}}}},
            verdictProperties(),
            {Text::tr("Check with simulated dips"),
             {{.path = QStringLiteral("tolerance.samples"),
               .label = Text::tr("Dips"),
               .help = Text::tr("Number of simulated dips with all deviations at once. They check "
                                "whether the separate effects add up. 0: no check.")},
              {.path = QStringLiteral("tolerance.seed"),
               .label = Text::tr("Seed"),
               .help = Text::tr("Start value of the random deviations in the simulated dips. "
                                "Another value gives other deviations.")}}}};
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
        return Text::tr("Seam");
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
