// A project as Python has it: open, change, save, run. Private to this folder.
#pragma once

#include "disk/FileVersion.h"
#include "import/trusted/ImportModel.h"
#include "pipeline/JobResult.h"
#include "project/ProjectValues.h"
#include "python/Values.h"

namespace dipwright::python {

// Values of a dip or a project by their paths, in Python's types.
using Values = std::map<QString, py::object>;

// Used by one thread of Python at a time.
class Job {
public:
    // Opens a project file. Throws Error.
    static Job opened(const QString& path);
    // Makes a project of a model. Throws Error or Cancelled.
    static Job made(const Project& begun, const QString& model, const ImportOptions& options,
                    const Progress& progress);

    const Project& project() const { return project_; }
    const QString& path() const { return path_; } // empty if never saved
    const QStringList& importNotes() const { return importNotes_; }

    py::object value(const QString& path) const;
    void setValue(const QString& path, const py::object& value);
    // Sets several values, or none if one of them is refused. Their order does not matter.
    void setValues(const Values& values);

    void addImmersion(const Values& values);
    void removeImmersion(int index);
    void setImmersions(const std::vector<Immersion>& immersions);
    void useProfile(const QString& kind, const QString& name);

    // Writes the project, by default to the file that it was opened from. Throws Error if another
    // program has it open or has changed it.
    void save(const std::optional<Path>& path);

    // The last result. The next run takes over what did not change.
    std::shared_ptr<const JobResult> last;

private:
    Project project_;
    QString path_;
    FileVersion known_; // contents of the file when it was read or written
    QStringList importNotes_;
};

// Returns a project without a model for these arguments of dipwright.new().
Project begunProject(const QString& model, const QString& preset,
                     const std::vector<Values>& immersions);
// Returns the values of one dip by their paths within the dip, such as "rotation_deg".
Values immersionValues(const Immersion& immersion);

} // namespace dipwright::python
