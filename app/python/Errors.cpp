// dipwright.Error and dipwright.Cancelled.
#include "python/Values.h"

#include "base/Error.h"
#include "base/Progress.h"
#include "python/Bindings.h"

namespace dipwright::python {
namespace {

constexpr const char* errorText = "Something is wrong with a file, a value or a solver. The text "
                                  "is one sentence that says what is\n"
                                  "wrong, where, and what to do.";
constexpr const char* cancelledText =
    "The work was cancelled, because its progress callback returned False.";

// Makes a class of exceptions in the module. The pointer is valid until Python ends.
PyObject* newException(py::module_& module, const char* name, const char* text) {
    const std::string fullName = std::string("dipwright.") + name;
    PyObject* type = PyErr_NewExceptionWithDoc(fullName.c_str(), text, PyExc_Exception, nullptr);
    module.add_object(name, type);
    return type;
}

void setError(PyObject* type, const Error& error) {
    const py::object instance =
        py::reinterpret_borrow<py::object>(type)(error.sentence().simplified());
    instance.attr("message") = error.message();
    instance.attr("where") = error.where();
    PyErr_SetObject(type, instance.ptr());
}

} // namespace

void bindErrors(py::module_& module) {
    static PyObject* const error = newException(module, "Error", errorText);
    static PyObject* const cancelled = newException(module, "Cancelled", cancelledText);
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const Error& fault) {
            setError(error, fault);
        } catch (const Cancelled&) {
            PyErr_SetString(cancelled, "Cancelled");
        } catch (const std::bad_alloc&) {
            PyErr_SetString(PyExc_MemoryError, "There is not enough memory; choose a smaller film, "
                                               "field or resolution");
        }
    });
}

} // namespace dipwright::python
