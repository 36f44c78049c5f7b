// Defines a solver that caches its dips. It makes tests faster, because all fits of one part begin
// with the same dips.
#pragma once

#include <dipwright/FilmSolver.h>

#include <mutex>

namespace dipwright::test {

// Calls `module`, to which it keeps a reference, for dips that are not cached. All dips must be of
// one body.
class RememberedDips : public solver::SolverModule {
public:
    explicit RememberedDips(const solver::SolverModule& module) : module_(module) {}

    const char* unavailableReason() const override { return module_.unavailableReason(); }
    const char* device() const override { return module_.device(); }
    std::unique_ptr<solver::FilmSolver> create() const override { return module_.create(); }
    bool runBatch(std::span<solver::BatchItem> items, solver::CancelFunction cancelled,
                  void* context) const override;

private:
    const solver::SolverModule& module_;
    mutable std::mutex mutex_;
    mutable std::vector<solver::BatchItem> known_;
};

} // namespace dipwright::test
