// dipwright-cad-reader: as dipwright-reader (main.cpp), for one CAD file.
#include "import/cad/CadReader.h"
#include "reader/Reader.h"

namespace dipwright {
namespace {

void readFiles(const ReaderJob& job, Pipe& pipe) {
    const Progress progress{
        [&pipe](double share, const QString& text) { pipe.report(share, text); }, {}};
    pipe.hand(readCad(job.names.value(0), pipe, job.tessellation, progress));
}

} // namespace
} // namespace dipwright

int main(int argc, char* argv[]) {
    using namespace dipwright;
    runReader(argc, argv, {{Budget::CadMemory, Budget::CadMilliseconds}, &prepareCad, &readFiles});
}
