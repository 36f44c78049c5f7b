// Fuzzes the reader of a note of unfinished work. An accepted note contains an absolute path of the
// work and the folders that contain it. It must survive writing and reading again.
#include "disk/UnfinishedNote.h"

#include <QDir>

#include <algorithm>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    using namespace dipwright;
    const auto note = noteOf({reinterpret_cast<const char*>(data), qsizetype(size)});
    const auto isAround = [&note](const QString& folder) {
        return QDir::isAbsolutePath(folder) && note->work.startsWith(folder);
    };
    if (note && (!QDir::isAbsolutePath(note->work) || noteOf(bytesOf(*note)) != note ||
                 !std::all_of(note->made.begin(), note->made.end(), isAround))) {
        std::abort();
    }
    return 0;
}
