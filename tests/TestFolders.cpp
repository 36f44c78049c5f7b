#include "TestFolders.h"

QString binaryFolder(const char* below) {
    return QLatin1String(DIPWRIGHT_BINARY_FOLDER) + QLatin1String(below);
}

QString pluginFolder(const char* below) {
    return QLatin1String(DIPWRIGHT_PLUGINS) + QLatin1String(below);
}

QString badModuleFolder(const char* below) {
    return QLatin1String(DIPWRIGHT_BAD_MODULES) + QLatin1String(below);
}

QString sampleFolder(const char* below) {
    return QLatin1String(DIPWRIGHT_SAMPLE_FOLDER) + QLatin1String(below);
}

QString sourceFolder(const char* below) {
    return QLatin1String(DIPWRIGHT_SOURCE_FOLDER) + QLatin1String(below);
}

QString sharedFolder(const char* below) {
    return sourceFolder("/../shared") + QLatin1String(below);
}
