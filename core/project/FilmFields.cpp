#include "project/FilmFields.h"

#include "project/FieldMakers.h"

#include <QCoreApplication>
#include <optional>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(FilmFields)
};

using Film = FilmBehaviour;

// Gathered to below 2/3 the plane film has no equilibrium of its own; at 1 nothing keeps it flat.
constexpr double leastGathering = 0.67, mostGathering = 0.98;

QStringList widthAndHeight() {
    return {Text::tr("W", "width"), Text::tr("H", "height")};
}

MaterialField<Film> edge(const char* path, const QString& label, bool FilmEdges::*side) {
    return {choice<Film>(
                path, edgeWords(), [side](auto& f) -> auto& { return f.edges.*side; }),
            {.label = label,
             .help = Text::tr("Whether this side of the film floats freely or is held by a barrier "
                              "in the tank."),
             .words = {{QStringLiteral("free"), Text::tr("Free")},
                       {QStringLiteral("pinned"), Text::tr("Held by a barrier")}}}};
}

void addFloating(std::vector<MaterialField<Film>>& fields) {
    fields.push_back(
        {numbers<Film>(
             "swell", 2, 0.5, 2,
             [](auto& f, int part) -> auto& { return part == 0 ? f.swellX : f.swellY; }),
         {.label = Text::tr("Swell"),
          .help = Text::tr("How much the wetted film has grown over the printed one, across and "
                           "down. Measure it: it is the first number to calibrate, and the sheet "
                           "is printed smaller by it."),
          .unit = Unit::Ratio,
          .parts = widthAndHeight(),
          .linked = true}});
    fields.push_back(
        {numberOrInfinity<Film>(
             "relaxation_time_s", 0, 1e6, [](auto& f) -> auto& { return f.relaxationTime; }),
         {.label = Text::tr("Relaxation"),
          .help = Text::tr("How fast stress in the floating film decays. An elastic film remembers "
                           "its shape for ever; a viscous one, at 0 s, forgets at once."),
          .unit = Unit::Time,
          .absent = Text::tr("Elastic"),
          .isOfProductionFilm = true}});
    fields.push_back(
        {uncountedWhenUsual(number<Film>(
             "growth_per_s", 0, mostGrowthRate, [](auto& f) -> auto& { return f.growthRate; })),
         {.label = Text::tr("Growth"),
          .help = Text::tr("How fast the film goes on growing while it floats, in a second of the "
                           "dip and at its begin. What is on the body grows no more."),
          .unit = Unit::ShareRate,
          .isOfProductionFilm = true}});
    fields.push_back(
        {uncountedWhenUsual(number<Film>(
             "growth_limit", 0, mostGrowth, [](auto& f) -> auto& { return f.growthLimit; })),
         {.label = Text::tr("Grows by at most"),
          .help = Text::tr("Total growth of the floating film after a long time, relative to its "
                           "length at the start of the dip. 0: the film does not grow."),
          .unit = Unit::Share,
          .isOfProductionFilm = true}});
    fields.push_back(
        {number<Film>(
             "contact_distance_mm", 0, 10, [](auto& f) -> auto& { return f.contactDistance; }),
         {.label = Text::tr("Contact distance"),
          .help = Text::tr("How near a film point has to come to the surface to touch it."),
          .unit = Unit::Length}});
}

void addLaws(std::vector<MaterialField<Film>>& fields) {
    fields.push_back(
        {uncountedWhenUsual(number<Film>(
             "grip_fade_deg", 0.1, 45, [](auto& f) -> auto& { return f.gripFade; })),
         {.label = Text::tr("Grip fades over"),
          .help = Text::tr("So far before the overhang the body begins to lose its grip on the "
                           "film. A guess: no film was measured."),
          .unit = Unit::Angle,
          .isOfProductionFilm = true}});
    fields.push_back(
        {uncountedWhenUsual(number<Film>(
             "gathering_stretch", leastGathering, mostGathering,
             [](auto& f) -> auto& { return f.gatheringStretch; })),
         {.label = Text::tr("Gathers below"),
          .help = Text::tr("Film pushed together to a mean stretch below this gathers, and hardly "
                           "resists any more. A guess: no film was measured."),
          .unit = Unit::Ratio,
          .isOfProductionFilm = true}});
}

template <typename Part>
void findWords(const std::vector<MaterialField<Part>>& fields, const QString& prefix,
               const QString& path, std::optional<FieldWords>& found) {
    for (const MaterialField<Part>& one : fields) {
        if (prefix + one.field.path == path) {
            found = one.words;
        }
    }
}

} // namespace

std::vector<MaterialField<FilmBehaviour>> filmBehaviourFields() {
    std::vector<MaterialField<Film>> fields;
    addFloating(fields);
    addLaws(fields);
    fields.push_back(edge("edges.left", Text::tr("Left"), &FilmEdges::leftPinned));
    fields.push_back(edge("edges.right", Text::tr("Right"), &FilmEdges::rightPinned));
    fields.push_back(edge("edges.top", Text::tr("Top"), &FilmEdges::topPinned));
    fields.push_back(edge("edges.bottom", Text::tr("Bottom"), &FilmEdges::bottomPinned));
    return fields;
}

std::vector<MaterialField<InkLaw>> inkLawFields() {
    return {
        {numbers<InkLaw>(
             "exponents", lightInks, 0, mostInkExponent,
             [](auto& ink, int part) -> auto& { return ink.exponents[std::size_t(part)]; }),
         {.label = Text::tr("Ink thins by"),
          .help = Text::tr("The exponent n: ink printed with density D shows D·J^−n where film is "
                           "stretched to J times its area. 1 for dye, 0 for dots that hide what "
                           "is behind them. A guess, taken for inks without tones."),
          .parts = {Text::tr("C", "cyan"), Text::tr("M", "magenta"), Text::tr("Y", "yellow")},
          .linked = true}},
        {leftOutWhenUsual(numbers<InkLaw>(
             "black_white_exponents", inkCount - lightInks, 0, mostInkExponent,
             [](auto& ink, int part) -> auto& {
                 return ink.exponents[std::size_t(lightInks + part)];
             })),
         {.label = Text::tr("Black and white"),
          .help = Text::tr("The same of black and white ink, which printers in CMYK have: "
                           "there each ink is made up for by itself, after separation."),
          .parts = {Text::tr("K", "black"), Text::tr("W", "white")}}},
        {inkTonesField<InkLaw>(
             "tones", [](auto& ink) -> auto& { return ink.tones; }),
         {.label = Text::tr("Ink, measured"),
          .help = Text::tr("What a step wedge told, tone by tone: ink, density, exponent, "
                           "bend, greatest stretch (dipwright-cli profile wedge).")}}};
}

FilmLimitFields filmLimitFields() {
    const QString project = Text::tr("As in the project");
    return {{number<ProcessSettings>(
                 "tear_stretch", 1, 100, [](auto& p) -> auto& { return p.tearStretch; }),
             {.label = Text::tr("Tears at"),
              .help = Text::tr("How many times its length or its area film can be stretched before "
                               "it tears. Torn film is marked and not painted."),
              .unit = Unit::Ratio,
              .absent = project,
              .whenPresent = 4}},
            {number<ProcessSettings>(
                 "overhang_deg", 0, 90, [](auto& p) -> auto& { return p.overhang; }),
             {.label = Text::tr("Overhang"),
              .help = Text::tr("Film holds on faces that turn upwards by no more than this."),
              .unit = Unit::Angle,
              .absent = project,
              .whenPresent = 20}}};
}

FieldWords materialWords(const QString& path) {
    std::optional<FieldWords> found;
    findWords(filmBehaviourFields(), {}, path, found);
    findWords(inkLawFields(), QStringLiteral("ink_"), path, found);
    const FilmLimitFields limits = filmLimitFields();
    findWords<ProcessSettings>({limits.tearStretch, limits.overhang}, {}, path, found);
    return found.value();
}

} // namespace dipwright
