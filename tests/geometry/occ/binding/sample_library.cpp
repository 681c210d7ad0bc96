// A library that tells where the references to its own symbols lead.
#include <cstring>

extern "C" {

int sampleData = 7;

__attribute__((noinline)) const void* sampleFunction() {
  static int own = 0;
  ++own;  // or the compiler gives the same address to all that stays 0
  return &own;
}

using Function = const void* (*)();
Function sampleTable[] = {nullptr, &sampleFunction};

// Each of these takes another way.
const void* placeOfData() { return &sampleData; }
const void* placeCalled() { return sampleFunction(); }
const void* placeInTable() { return sampleTable[1](); }

int sampleValues[] = {10, 20, 30, 40};
int* sampleInside = &sampleValues[2];
int valueInside() { return *sampleInside; }

int oneOfTwo() { return 11; }
int (*chooseOne())() { return &oneOfTwo; }
int chosenOne() __attribute__((ifunc("chooseOne")));
int (*sampleChosen)() = &chosenOne;
int valueChosen() { return chosenOne() + sampleChosen(); }

int countedInThread() {
  static thread_local int calls = 0;
  return ++calls;
}

int valueOfOtherLibrary() { return static_cast<int>(std::strlen("text")); }

#ifdef AF2_CALLS_WHAT_IS_MISSING
int definedNowhere();
int valueOfMissing() { return definedNowhere(); }
#endif

}  // extern "C"

template <class T>
struct InOnePlace {
  static T value;
};
template <class T>
T InOnePlace<T>::value{};

extern "C" const void* placeOfUnique() { return &InOnePlace<int>::value; }
