// Works on a band of the film's rows with one thread, through several Jacobi or Gauss–Seidel sweeps
// between two barriers. It recomputes the neighbours' rows that it needs, with the same arithmetic.
// So the result does not depend on the division into bands.
#pragma once

#include "paper/cpu/PaperModel.h"

namespace dipwright::cpu {

// The work of all bands between two barriers.
struct PaperPass {
    bool predicts = false; // the pass starts with the prediction and the contact search
    int sweeps = 0;
    double descent = 0;                // descent of the body, mm
    numerics::BodyFrame<double> frame; // the body's frame at `descent`
};

// The points that all bands share. Each band writes its own rows of `film`. It also writes the rows
// that its neighbours need into `published`. Bands read one copy of `published` while they write
// the other.
struct SharedFilm {
    FilmRows film;
    std::array<FilmRows, 2> published;
    int read = 0;
    FilmActivity activity;
};

// Returns how many rows beyond each edge of a band one sweep reads.
int rowsPerSweep(solver::Relaxation relaxation);

class PaperBand {
public:
    // The band owns rows first … last − 1; `first` is even. A pass has at most `sweeps` sweeps.
    PaperBand(const PaperModel& model, SharedFilm& shared, int first, int last, int sweeps);

    void run(const PaperPass& pass);

private:
    // Tracks how far a chunk's points are from the body. The distance field gives the distance that
    // each point can travel before contact. The point is not sampled again before that.
    struct Approach {
        float travelled = 0; // mm, upper bound of the travel of the body and the film together
        float nearest = 0;   // the smallest value of `points`
        std::array<float, chunkColumns>
            // The value of `travelled` at which each point may reach the body, computed from its φ.
            points{};

        bool isNear(float margin) const { return nearest <= travelled + margin; }
    };

    void runJacobi();
    void jacobi(int row, int sweep);
    void jacobi(int row, int sweep, const std::uint8_t* isBusy);

    void runGaussSeidel();
    void gaussSeidel(int pair, bool hasPairAbove);
    void solveAlongRow(int row);
    void solveBetweenRows(int row);
    void solve(const WorkingRow& first, const WorkingRow& second, std::array<float, 2> rest,
               float length, float stiffness, const AlignedVector<float>& exists) const;

    void load(int row);
    void store(int row);
    void findContacts(int row, int chunk);
    void adhere(int row, int column, numerics::Vector3<double> place);

    bool isOwn(int row) const { return row >= first_ && row < last_; }
    bool isReadByNeighbour(int row) const;
    bool splitsColumns() const {
        return model_.settings.relaxation == solver::Relaxation::GaussSeidel;
    }
    WorkingRow working(int row);
    Approach* approaches(int row);

    const PaperModel& model_;
    SharedFilm& shared_;
    const int first_, last_;
    const int reach_; // number of rows on each side of the band that are recomputed
    const int firstLoaded_, lastLoaded_;
    const int ringRows_;
    PaperPass pass_;
    AlignedVector<float> ring_;      // the working rows in use
    AlignedVector<float> unsplit_;   // a working row before its columns are split by parity
    AlignedVector<float> noRow_;     // points of weight 0
    AlignedVector<float> fromAbove_; // three arrays per sweep, see JacobiTask::fromAbove
    AlignedVector<float> evenHasRight_, oddHasRight_, allExist_; // per pair of columns
    std::vector<Approach> approaches_;                           // per loaded row and chunk
    std::vector<float> motion_; // motion per chunk of the row that is being loaded, mm
    std::vector<std::uint8_t> isNeeded_;
};

} // namespace dipwright::cpu
