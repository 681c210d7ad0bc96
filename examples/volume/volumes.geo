// From a surface mesh by AF2 to tetrahedra:
//   af2 mesh part.step --size 1 -o part.msh
//   gmsh -3 part.msh volumes.geo -o filled.msh
// Gmsh does not fill volumes of mesh files. Therefore each is replaced by one with the same number,
// physical group and surfaces. The elements on the surfaces stay as they are.
volumes() = Volume{:};
For i In {0 : #volumes() - 1}
  v = volumes(i);
  surfaces() = Abs(Boundary{ Volume{v}; });
  Delete { Volume{v}; }
  Surface Loop(v) = surfaces();
  Volume(v) = {v};
  Physical Volume(v) = {v};
EndFor
