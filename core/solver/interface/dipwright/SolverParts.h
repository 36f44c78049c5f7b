// Named parts, by which the program and its modules gain abilities without breaking older modules.
//
// A part is a small structure of functions with a name and a version. A published version never
// changes. A new ability gets a new part, or a new version beside the old one. So an older module
// finds everything unchanged, and a newer module can ask which parts exist. Both sides have parts:
//
// - The program: a module may export dipwrightUseProgram. The program calls it once, after loading
//   the module, with a function that returns the program's parts.
// - The module: it may export dipwrightSolverPart, which returns the module's parts. The program
//   asks for the parts that it knows. Each module also has its solver (FilmSolver.h), which
//   dipwrightSolverModule returns; the program supports its versions 3 and 4.
//
// A side that asks for a missing part gets nullptr, and must work without the part. Parts belong to
// the side that returns them, and live as long as the process.
#pragma once

#include <dipwright/FilmSolver.h>

#include <cstddef>

namespace dipwright::solver {

// Returns a part by its name and version, or nullptr. Any thread may call it.
using GetPart = const void* (*)(const char* name, int version);

// Returns the part of a type that has a `name` and a `version`, such as ProgramPart; or nullptr.
template <typename Part>
const Part* part(GetPart getPart) {
    return getPart == nullptr ? nullptr
                              : static_cast<const Part*>(getPart(Part::name, Part::version));
}

// A part of the program: names the program that loaded the module.
struct ProgramPart {
    static constexpr const char* name = "program";
    static constexpr int version = 1;

    const char* (*programName)();    // "Dipwright"
    const char* (*programVersion)(); // "1.0.0"
};

// A part of a module: the limits of its solver. The program refuses larger films with a sentence
// and does not begin them.
struct LimitsPart {
    static constexpr const char* name = "limits";
    static constexpr int version = 1;

    std::size_t (*mostPoints)(); // of a film; 0: any number
};

} // namespace dipwright::solver

// Symbols that a module may export with C linkage, and their types.
#define DIPWRIGHT_USE_PROGRAM_ENTRY "dipwrightUseProgram"
using DipwrightUseProgramEntry = void(dipwright::solver::GetPart getPart);
#define DIPWRIGHT_SOLVER_PART_ENTRY "dipwrightSolverPart"
using DipwrightSolverPartEntry = const void*(const char* name, int version);
