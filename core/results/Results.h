// What a run leaves behind: VTK files, heatmaps, proof pictures.
//
// The pictures are lettered, which needs a QGuiApplication (the "offscreen" platform will do). All
// functions are reentrant and give the same bytes for the same input.
#pragma once

#include "dip/Coverage.h"
#include "dip/LaidFilm.h"
#include "share/BodyShare.h"
#include "texture/ReverseTexture.h"

#include <QJsonObject>
#include <QRgb>

namespace dipwright {

// VTK XML PolyData files as docs/files-and-commands.md, "Result files", says, in the pose frame:
// float arrays, compressed. `appearance`: of the body, whose texture coordinates are written.
QByteArray filmVtp(const LaidFilm& laid, const SurfaceAppearance& appearance);
QByteArray bodyVtp(const PosedBody& body, const SurfaceAppearance& appearance,
                   const Coverage& coverage);

// The mean stretch of each film point over the flat film, ink side up, with a labelled scale, the
// outline of the painted area and its distribution. `longEdge` pixels tall.
QImage stretchMap(const LaidFilm& laid, int longEdge);

// Where film on the body is compressed and may fold: the smaller principal stretch λ2 over the flat
// film, drawn like stretchMap(); white where nothing is compressed.
QImage wrinklingMap(const LaidFilm& laid, int longEdge);

// How far the sheet moves when it is computed more finely: `changes` in mm, told in `unit`, one of
// each film point, NaN where it paints in one of the dips only; over the flat film, drawn like
// stretchMap(). Marked film on the body is hatched. The colours go up to a few times `limit`, mm,
// what a place of a certain sheet changes by at most; what is past them has a colour of its own.
QImage certaintyMap(const LaidFilm& laid, const std::vector<float>& changes, double limit,
                    int longEdge, LengthUnit unit = LengthUnit::Millimetre);

// How far colours may land off their places: `spread` in mm, told in `unit`, one of each film
// point; over the flat film, drawn like certaintyMap(), the colours up to a few times `limit`, mm.
QImage toleranceMap(const LaidFilm& laid, const std::vector<float>& spread, double limit,
                    int longEdge, LengthUnit unit = LengthUnit::Millimetre);

// Colour maps of even lightness steps, made in OKLab: "lagoon" (dark blue over green to yellow),
// "dusk" (blue over grey to yellow, the same to readers with any colour vision), both light at 1;
// "balance" (blue over near-white to orange, the middle at 0.5); "grey".
QStringList colourMaps();
// The colour at `value`, clamped to 0 … 1. Throws Error on an unknown map.
QColor mapColour(const QString& map, double value);

// By which film that is marked so is told from other film in maps, proof and views.
QColor markColour(solver::PointMark mark);

// By which the shares of two dips are told apart, in maps and views.
QColor painterColour(Painter painter);

// A colour of a shared body and what it means.
struct ShareLine {
    QColor colour;
    QString text;
};
// Who paints how much of the body, mm² and per cent, and how long the join is. `dips`: the names of
// the two.
std::vector<ShareLine> shareLines(const BodyShare& share, const QStringList& dips);

// The flat film of dip `dip`, 0 or 1, in the colours of those who paint what it lies on, and the
// join; ink side up, the whole film.
QImage sharePicture(const LaidFilm& laid, const BodyShare& share, std::size_t dip, QSize pixels);

// How far a floating film lies off its place when the body comes down, how much it has grown beyond
// what was reckoned with, and how much deeper the body is dipped. The film is much alike
// everywhere, so that the body meets other ink and no other film; what is laid is laid as it would
// be in a deeper dip.
struct FilmSlip {
    std::array<Millimetres, 2> shift{}; // along the film's X and Z
    Degrees turn{0};                    // from X to Z, about the film's middle
    double swell = 1;                   // times as large
    Millimetres deeper{0};              // less deep where negative
    bool operator==(const FilmSlip&) const = default;
};

// A plate of a film that is printed with an ink of its own.
struct PrintedSpot {
    QImage tints;  // of the flat film, Grayscale8
    QColor colour; // of full tint on white
};

// One immersion's film, on the body in its own pose, wearing a picture.
struct FilmAppearance {
    std::shared_ptr<const LaidFilm> laid;
    QImage image; // of the flat film
    FilmSlip slip = {};
    // mm from the body's lowest point up to the water at the end of the dip that was reckoned with;
    // a slip that goes deeper needs a film that was dipped so deep.
    double depth = std::numeric_limits<double>::infinity();
    QImage white = {};                   // tints of its white layer, Grayscale8; null: none
    std::vector<PrintedSpot> spots = {}; // light goes through them as through the other inks
};

// What the films' ink is seen on.
struct Ground {
    // Of the bare body: light goes through the ink to it, but for what white hides. None: a bare
    // body is shown light grey, and ink as it looks on white.
    std::optional<QColor> base = {};
    bool whiteOutside = false; // white was printed first: it lies over the colour
};

// What the films give the body, by the middles of the fine triangles: a colour each, as the proof
// has it in white light. All cores.
std::vector<QRgb> printedColours(const RefinedMesh& body, const std::vector<FilmAppearance>& films,
                                 const InkSettings& ink, const Ground& ground = {});

struct ProofOptions {
    QSize tile{640, 640}; // one view's pixels
    InkSettings ink = {}; // by which the images were compensated, if they were
    Ground ground = {};
};

// A body on a light table, ready to be shown in proofs: what is the same whatever film it wears.
struct ProofStage;
// Computed by rays on all cores. Keeps a reference to the model. Any thread may read.
std::shared_ptr<const ProofStage> proofStage(const TexturedMesh& model);

// One dip of a shared body.
struct SharedFilm {
    std::shared_ptr<const LaidFilm> laid;
    QString name; // the dip's
};
// Who paints what: the body from six sides, both flat films, the areas. `tile`: a view's pixels.
// Throws Cancelled.
QImage coveragePicture(const ProofStage& stage, const BodyShare& share,
                       const std::vector<SharedFilm>& films, int tile, const Progress& progress);

// The body as it will come out, in model orientation: front (along −Z), right and above over back,
// left and below, the four sides from slightly above. Where films lie over each other
// their densities add up, unpainted body is light grey, what marked film paints is hatched. Traced
// by Embree on all cores, without OpenGL; throws Cancelled.
QImage proofPicture(const ProofStage& stage, const std::vector<FilmAppearance>& films,
                    const ProofOptions& options, const Progress& progress);

} // namespace dipwright
