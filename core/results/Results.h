// Makes the result files of a run: VTK files, maps and proof pictures.
//
// The pictures contain text, which needs a QGuiApplication (the "offscreen" platform suffices). All
// functions are reentrant and return the same bytes for the same input.
#pragma once

#include "dip/Coverage.h"
#include "dip/LaidFilm.h"
#include "share/BodyShare.h"
#include "texture/ReverseTexture.h"

#include <QJsonObject>
#include <QRgb>

namespace dipwright {

// Return VTK XML PolyData files in the pose frame, with compressed float arrays
// (docs/files-and-commands.md, "Result files"). `appearance`: gives the body's texture coordinates.
QByteArray filmVtp(const LaidFilm& laid, const SurfaceAppearance& appearance);
QByteArray bodyVtp(const PosedBody& body, const SurfaceAppearance& appearance,
                   const Coverage& coverage);

// Draws the mean stretch of each film point on the flat film, ink side up. Adds a labelled scale,
// the outline of the painted area and its distribution. `longEdge`: pixels.
QImage stretchMap(const LaidFilm& laid, int longEdge);

// Draws where film on the body is compressed and may fold: the smaller principal stretch λ2, drawn
// like stretchMap(). White where nothing is compressed.
QImage wrinklingMap(const LaidFilm& laid, int longEdge);

// Draws the numerical error on the flat film, like stretchMap(), with marked film hatched.
// `changes`: of each film point in mm, shown in `unit`; NaN where only one of the dips paints. The
// scale ends at a few times `limit` (mm); higher values have a colour of their own.
QImage numericalErrorMap(const LaidFilm& laid, const std::vector<float>& changes, double limit,
                         int longEdge, LengthUnit unit = LengthUnit::Millimetre);

// Draws how far handling may move the image, like numericalErrorMap(). `spread`: of each film point
// in mm, shown in `unit`. The scale ends at a few times `limit` (mm).
QImage toleranceMap(const LaidFilm& laid, const std::vector<float>& spread, double limit,
                    int longEdge, LengthUnit unit = LengthUnit::Millimetre);

// Names of the colour maps, all with even lightness steps: "lagoon" (dark blue, green, yellow),
// "dusk" (blue, grey, yellow; equal for any colour vision), "balance" (blue, near-white at 0.5,
// orange) and "grey". "lagoon" and "dusk" are light at 1.
QStringList colourMaps();
// Returns the colour at `value`, clamped to 0 … 1. Throws Error for an unknown map.
QColor mapColour(const QString& map, double value);

// Returns the colour of marked film in maps, proof and views.
QColor markColour(solver::PointMark mark);

// Returns the colour of a dip's share in maps and views.
QColor painterColour(Painter painter);

// A colour of a shared body and its meaning.
struct ShareLine {
    QColor colour;
    QString text;
};
// Returns how much of the body each dip paints, in mm² and per cent, and the length of the seam.
// `dips`: the names of the two dips.
std::vector<ShareLine> shareLines(const BodyShare& share, const QStringList& dips);

// Draws the whole flat film of dip `dip`, 0 or 1, ink side up, with the seam. Each place has the
// colour of the dips that paint the body there.
QImage sharePicture(const LaidFilm& laid, const BodyShare& share, std::size_t dip, QSize pixels);

// A placement error of the floating film, additional swell, and additional depth of the dip. The
// body then meets other ink, but the film deforms as before, because film is nearly uniform. A
// greater depth uses the film of a deeper dip.
struct FilmPlacementError {
    std::array<Millimetres, 2> shift{}; // along the film's X and Z
    Degrees turn{0};                    // from X to Z, about the film's centre
    double swell = 1;                   // factor on the film's size
    Millimetres deeper{0};              // negative: less deep
    bool operator==(const FilmPlacementError&) const = default;
};

// A spot colour's plate on a film.
struct PrintedSpot {
    QImage tints;  // of the flat film, Grayscale8
    QColor colour; // full tint on white
};

// The film of one dip on the body, in the dip's pose, with its picture.
struct FilmAppearance {
    std::shared_ptr<const LaidFilm> laid;
    QImage image; // of the flat film
    FilmPlacementError slip = {};
    // Planned depth: mm from the body's lowest point up to the water at the end of the dip. A slip
    // that goes deeper needs a film that was dipped at least that deep.
    double depth = std::numeric_limits<double>::infinity();
    QImage white = {};                   // tints of its white layer, Grayscale8; null: none
    std::vector<PrintedSpot> spots = {}; // transparent like the other inks
};

// The surface below the ink.
struct Ground {
    // Colour of the bare body, seen through the ink where no white hides it. None: the bare body is
    // light grey, and ink looks as on white.
    std::optional<QColor> base = {};
    bool whiteOutside = false; // white was printed first and lies over the colours
};

// Returns the colour at the centre of each fine triangle of the body in white light, as in the
// proof. All cores.
std::vector<QRgb> printedColours(const RefinedMesh& body, const std::vector<FilmAppearance>& films,
                                 const InkSettings& ink, const Ground& ground = {});

struct ProofOptions {
    QSize tile{640, 640}; // pixels of one view
    InkSettings ink = {}; // how the images were compensated, if at all
    Ground ground = {};
};

// A body on a light table: the part of a proof that does not depend on the films.
struct ProofStage;
// Computes the stage by rays on all cores. Keeps a reference to the model. Any thread may read it.
std::shared_ptr<const ProofStage> proofStage(const TexturedMesh& model);

// One dip of a shared body.
struct SharedFilm {
    std::shared_ptr<const LaidFilm> laid;
    QString name; // of the dip
};
// Draws which dip paints what: the body from six sides, both flat films, and the areas. `tile`:
// pixels of one view. Throws Cancelled.
QImage coveragePicture(const ProofStage& stage, const BodyShare& share,
                       const std::vector<SharedFilm>& films, int tile, const Progress& progress);

// Draws the painted body in model orientation: front (along −Z), right and above in the upper row;
// back, left and below in the lower. The four sides are seen from slightly above. Densities of
// overlapping films add up, the bare body is light grey, and marked film is hatched. Traced by
// Embree on all cores, without OpenGL; throws Cancelled.
QImage proofPicture(const ProofStage& stage, const std::vector<FilmAppearance>& films,
                    const ProofOptions& options, const Progress& progress);

} // namespace dipwright
