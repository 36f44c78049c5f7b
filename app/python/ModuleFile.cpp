#include "python/ModuleFile.h"

#include <QDir>
#include <QFile>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace dipwright::python {

QString moduleFile() {
#ifdef _WIN32
    HMODULE module = nullptr;
    wchar_t name[32768] = {};
    if (GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS |
                               GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
                           reinterpret_cast<LPCWSTR>(&moduleFile), &module) == 0 ||
        GetModuleFileNameW(module, name, DWORD(std::size(name))) == 0) {
        return {};
    }
    return QDir::fromNativeSeparators(QString::fromWCharArray(name));
#else
    Dl_info info{};
    return dladdr(reinterpret_cast<const void*>(&moduleFile), &info) != 0
               ? QFile::decodeName(info.dli_fname)
               : QString();
#endif
}

} // namespace dipwright::python
