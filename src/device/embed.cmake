# Writes OUT: a C++ file that holds each of FILES (relative to ROOT) as a raw string, for device/source.cpp.
# Raw strings may not be longer than 65,536 bytes everywhere; no kernel file comes near it.
set(TEXT "#include \"device/source.h\"\n\nnamespace nacre::device {\n\nconst std::map<std::string, std::string_view> &embedded_kernels() {\n    static const std::map<std::string, std::string_view> files = {\n")
foreach(FILE ${FILES})
  file(READ ${ROOT}/${FILE} BODY)
  string(APPEND TEXT "{\"${FILE}\", R\"kernel_text(${BODY})kernel_text\"},\n")
endforeach()
string(APPEND TEXT "    };\n    return files;\n}\n\n} // namespace nacre::device\n")
file(WRITE ${OUT} "${TEXT}")
