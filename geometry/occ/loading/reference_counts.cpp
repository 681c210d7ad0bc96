// OpenCASCADE counts the handles of an object by locked instructions, a sixth of the time of
// reading and meshing a model of 1,000 faces (docs/performance.md). In programs that contain these
// functions, the dynamic linker finds them before OpenCASCADE's. They lock only once the process
// has a second thread, like std::shared_ptr.
#pragma GCC visibility push(default)  // for the dynamic linker
#include <Standard_Transient.hxx>
#pragma GCC visibility pop
#include <Standard_Version.hxx>

#if __has_include(<sys/single_threaded.h>) && OCC_VERSION_HEX < 0x070800  // later ones are inline
#include <sys/single_threaded.h>

void Standard_Transient::IncrementRefCounter() const {
  if (__libc_single_threaded != 0)
    myRefCount_ = myRefCount_ + 1;
  else
    __atomic_add_fetch(&myRefCount_, 1, __ATOMIC_SEQ_CST);
}

Standard_Integer Standard_Transient::DecrementRefCounter() const {
  if (__libc_single_threaded == 0) return __atomic_sub_fetch(&myRefCount_, 1, __ATOMIC_SEQ_CST);
  const Standard_Integer count = myRefCount_ - 1;
  myRefCount_ = count;
  return count;
}

#endif
