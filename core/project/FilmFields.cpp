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

// Below 2/3, gathered flat film has no equilibrium by itself; at 1, nothing keeps the film flat.
constexpr double leastGathering = 0.67, mostGathering = 0.98;

QStringList widthAndHeight() {
    return {Text::tr("W", "width"), Text::tr("H", "height")};
}

MaterialField<Film> edge(const char* path, const QString& label, bool FilmEdges::*side) {
    return {choice<Film>(
                path, edgeWords(), [side](auto& f) -> auto& { return f.edges.*side; }),
            {.label = label,
             .help = Text::tr("Whether this side of the film floats freely or a barrier in the "
                              "tank holds it."),
             .words = {{QStringLiteral("free"), Text::tr("Free")},
                       {QStringLiteral("pinned"), Text::tr("Held by a barrier")}}}};
}

void addFloating(std::vector<MaterialField<Film>>& fields) {
    fields.push_back(
        {numbers<Film>(
             "swell", 2, 0.5, 2,
             [](auto& f, int part) -> auto& { return part == 0 ? f.swellX : f.swellY; }),
         {.label = Text::tr("Swell"),
          .help = Text::tr("Size of the wetted film relative to the printed film, in width and "
                           "height. The sheet is printed smaller by this factor, so measure it "
                           "first."),
          .unit = Unit::Ratio,
          .parts = widthAndHeight(),
          .linked = true}});
    fields.push_back(
        {numberOrInfinity<Film>(
             "relaxation_time_s", 0, 1e6, [](auto& f) -> auto& { return f.relaxationTime; }),
         {.label = Text::tr("Relaxation"),
          .help = Text::tr("Time in which stress in the floating film decays. Elastic film keeps "
                           "its stress for ever; viscous film (0 s) loses it at once."),
          .unit = Unit::Time,
          .absent = Text::tr("Elastic"),
          .isOfProductionFilm = true}});
    fields.push_back(
        {notHashedIfDefault(inUnit("1/s", number<Film>(
                                              "growth_per_s", 0, mostGrowthRate,
                                              [](auto& f) -> auto& { return f.growthRate; }))),
         {.label = Text::tr("Growth rate"),
          .help = Text::tr("How fast the floating film grows at the start of the dip, per second. "
                           "Adhered film does not grow."),
          .unit = Unit::ShareRate,
          .isOfProductionFilm = true}});
    fields.push_back(
        {notHashedIfDefault(number<Film>(
             "growth_limit", 0, mostGrowth, [](auto& f) -> auto& { return f.growthLimit; })),
         {.label = Text::tr("Growth limit"),
          .help = Text::tr("Total growth of the floating film after a long time, relative to its "
                           "length at the start of the dip. 0: the film does not grow."),
          .unit = Unit::Share,
          .isOfProductionFilm = true}});
    fields.push_back(
        {number<Film>(
             "contact_distance_mm", 0, 10, [](auto& f) -> auto& { return f.contactDistance; }),
         {.label = Text::tr("Contact distance"),
          .help =
              Text::tr("A film point touches the part when it comes this close to its surface."),
          .unit = Unit::Length}});
}

void addLaws(std::vector<MaterialField<Film>>& fields) {
    fields.push_back(
        {notHashedIfDefault(number<Film>(
             "grip_fade_deg", 0.1, 45, [](auto& f) -> auto& { return f.gripFade; })),
         {.label = Text::tr("Grip fade range"),
          .help = Text::tr("The part loses its grip on the film gradually, in this range of angles "
                           "before the overhang. This value is a guess; no film was measured."),
          .unit = Unit::Angle,
          .isOfProductionFilm = true}});
    fields.push_back(
        {notHashedIfDefault(number<Film>(
             "gathering_stretch", leastGathering, mostGathering,
             [](auto& f) -> auto& { return f.gatheringStretch; })),
         {.label = Text::tr("Gathering stretch"),
          .help = Text::tr("Compressed film gathers where its mean stretch falls below this value. "
                           "Gathered film hardly resists further compression. This value is a "
                           "guess; no film was measured."),
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
    return {{numbers<InkLaw>(
                 "exponents", lightInks, 0, mostInkExponent,
                 [](auto& ink, int part) -> auto& { return ink.exponents[std::size_t(part)]; }),
             {.label = Text::tr("Ink exponent"),
              .help = Text::tr(
                  "How ink thins: where film is stretched to J times its area, ink of density D "
                  "has only the density D·J^−n. n is 1 for dye and 0 for opaque dots. Used for "
                  "inks without measured tones; the preset value is a guess."),
              .parts = {Text::tr("C", "cyan"), Text::tr("M", "magenta"), Text::tr("Y", "yellow")},
              .linked = true}},
            {omittedIfDefault(numbers<InkLaw>(
                 "black_white_exponents", inkCount - lightInks, 0, mostInkExponent,
                 [](auto& ink, int part) -> auto& {
                     return ink.exponents[std::size_t(lightInks + part)];
                 })),
             {.label = Text::tr("Ink exponent, black and white"),
              .help = Text::tr(
                  "The exponent n for black and white ink. Only CMYK printers use it, because only "
                  "for them each ink is compensated individually, after colour separation."),
              .parts = {Text::tr("K", "black"), Text::tr("W", "white")}}},
            {inkTonesField<InkLaw>(
                 "tones", [](auto& ink) -> auto& { return ink.tones; }),
             {.label = Text::tr("Measured ink"),
              .help = Text::tr(
                  "Values for each tone of a measured step wedge: ink, density, exponent, bend and "
                  "largest stretch. The command “dipwright-cli profile wedge” computes them.")}}};
}

FilmLimitFields filmLimitFields() {
    const QString project = Text::tr("As in the project");
    return {{number<ProcessSettings>(
                 "tear_stretch", 1, 100, [](auto& p) -> auto& { return p.tearStretch; }),
             {.label = Text::tr("Tear stretch"),
              .help = Text::tr("Film tears where its length or its area is stretched by more than "
                               "this factor. Torn film is marked and does not paint."),
              .unit = Unit::Ratio,
              .absent = project,
              .whenPresent = 4}},
            {number<ProcessSettings>(
                 "overhang_deg", 0, 90, [](auto& p) -> auto& { return p.overhang; }),
             {.label = Text::tr("Overhang"),
              .help = Text::tr("Film adheres to faces that turn up from the vertical by at most "
                               "this angle. Faces that turn up more release the film."),
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
