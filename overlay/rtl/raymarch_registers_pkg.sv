// SPDX-License-Identifier: MIT
// Made by dump_tables from protocol/; ./dev docs writes it again.
//
// A function NAME_KEY gives the code of a parameter. Its argument is all
// parameter words of NAME as one vector, with word 0 in bits 31:0. Yosys 0.23
// and Verilator 5.006 read this file: they take neither an unpacked argument
// nor `return`.
package raymarch_registers_pkg;
  /* verilator lint_off UNUSEDPARAM */
  /* verilator lint_off UNUSEDSIGNAL */

  // Byte offsets of the extended registers
  localparam logic [11:0] ID_OFFSET = 12'h020;
  localparam logic [11:0] VERSION_OFFSET = 12'h024;
  localparam logic [11:0] CAPABILITY_OFFSET = 12'h028;
  localparam logic [11:0] GEOMETRY_OFFSET = 12'h02C;
  localparam logic [11:0] CONTROL_OFFSET = 12'h030;
  localparam logic [11:0] COMMIT_OFFSET = 12'h034;
  localparam logic [11:0] STATUS_OFFSET = 12'h038;
  localparam logic [11:0] FRAMES_OFFSET = 12'h03C;
  localparam logic [11:0] CYCLES_OFFSET = 12'h040;
  localparam logic [11:0] CLOCK_HZ_OFFSET = 12'h044;
  localparam logic [11:0] SCRATCH_OFFSET = 12'h048;
  localparam logic [31:0] ID_VALUE = 32'h524D4152;

  // The highest and the lowest bit of each of their fields
  localparam int VERSION_MAJOR_MSB = 31;
  localparam int VERSION_MAJOR_LSB = 16;
  localparam int VERSION_MINOR_MSB = 15;
  localparam int VERSION_MINOR_LSB = 0;
  localparam int CAPABILITY_KIND_MSB = 31;
  localparam int CAPABILITY_KIND_LSB = 24;
  localparam int CAPABILITY_RAY_UNITS_MSB = 23;
  localparam int CAPABILITY_RAY_UNITS_LSB = 16;
  localparam int GEOMETRY_WIDTH_MSB = 31;
  localparam int GEOMETRY_WIDTH_LSB = 16;
  localparam int GEOMETRY_HEIGHT_MSB = 15;
  localparam int GEOMETRY_HEIGHT_LSB = 0;
  localparam int CONTROL_ENABLE_MSB = 0;
  localparam int CONTROL_ENABLE_LSB = 0;
  localparam int CONTROL_INTERRUPT_ENABLE_MSB = 1;
  localparam int CONTROL_INTERRUPT_ENABLE_LSB = 1;
  localparam int CONTROL_SHADOW_MSB = 2;
  localparam int CONTROL_SHADOW_LSB = 2;
  localparam int CONTROL_SOFT_RESET_MSB = 3;
  localparam int CONTROL_SOFT_RESET_LSB = 3;
  localparam int STATUS_BUSY_MSB = 0;
  localparam int STATUS_BUSY_LSB = 0;
  localparam int STATUS_COMMIT_PENDING_MSB = 1;
  localparam int STATUS_COMMIT_PENDING_LSB = 1;
  localparam int STATUS_FRAME_DONE_MSB = 2;
  localparam int STATUS_FRAME_DONE_LSB = 2;
  localparam int STATUS_FAULT_MSB = 3;
  localparam int STATUS_FAULT_LSB = 3;

  // marcher: signed distance scenes by sphere tracing, Lambert and ambient light (source 000)
  localparam int MARCHER_KIND = 0;
  localparam int MARCHER_WORDS = 8;
  function automatic logic signed [17:0] marcher_FX(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_FX = {words[95:78]};
  endfunction
  function automatic logic signed [17:0] marcher_FY(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_FY = {words[77:64], words[127:124]};
  endfunction
  function automatic logic signed [17:0] marcher_FZ(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_FZ = {words[123:106]};
  endfunction
  function automatic logic signed [17:0] marcher_RX(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_RX = {words[159:142]};
  endfunction
  function automatic logic signed [17:0] marcher_RY(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_RY = {words[141:128], words[191:188]};
  endfunction
  function automatic logic signed [17:0] marcher_RZ(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_RZ = {words[187:170]};
  endfunction
  function automatic logic signed [17:0] marcher_UX(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_UX = {words[223:206]};
  endfunction
  function automatic logic signed [17:0] marcher_UY(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_UY = {words[205:192], words[255:252]};
  endfunction
  function automatic logic signed [17:0] marcher_UZ(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_UZ = {words[251:234]};
  endfunction
  function automatic logic [31:0] marcher_ZM(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_ZM = {words[63:32]};
  endfunction
  function automatic logic signed [9:0] marcher_LX(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_LX = {words[29:20]};
  endfunction
  function automatic logic signed [9:0] marcher_LY(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_LY = {words[19:10]};
  endfunction
  function automatic logic signed [9:0] marcher_LZ(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_LZ = {words[9:0]};
  endfunction
  function automatic logic [9:0] marcher_R(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_R = {words[105:96]};
  endfunction
  function automatic logic [9:0] marcher_G(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_G = {words[169:160]};
  endfunction
  function automatic logic [9:0] marcher_B(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_B = {words[233:224]};
  endfunction
  function automatic logic [1:0] marcher_OBJ(input logic [32*MARCHER_WORDS-1:0] words);
    marcher_OBJ = {words[31:30]};
  endfunction

  // fractal: four fractal scenes in sixteen greys, bricks, dither, checkerboard (source 001)
  localparam int FRACTAL_KIND = 1;
  localparam int FRACTAL_WORDS = 7;
  function automatic logic signed [21:0] fractal_X(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_X = {words[21:0]};
  endfunction
  function automatic logic signed [21:0] fractal_Y(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_Y = {words[53:32]};
  endfunction
  function automatic logic signed [21:0] fractal_Z(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_Z = {words[85:64]};
  endfunction
  function automatic logic signed [21:0] fractal_FX(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_FX = {words[117:96]};
  endfunction
  function automatic logic signed [21:0] fractal_FY(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_FY = {words[149:128]};
  endfunction
  function automatic logic signed [21:0] fractal_FZ(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_FZ = {words[181:160]};
  endfunction
  function automatic logic [1:0] fractal_SCENE(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_SCENE = {words[193:192]};
  endfunction
  function automatic logic [0:0] fractal_DITHER(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_DITHER = {words[196:196]};
  endfunction
  function automatic logic [0:0] fractal_TEXTURE(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_TEXTURE = {words[197:197]};
  endfunction
  function automatic logic [0:0] fractal_CHECKER(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_CHECKER = {words[198:198]};
  endfunction
  function automatic logic [0:0] fractal_COLOUR(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_COLOUR = {words[199:199]};
  endfunction
  function automatic logic [7:0] fractal_HUE(input logic [32*FRACTAL_WORDS-1:0] words);
    fractal_HUE = {words[207:200]};
  endfunction

  // sphere: spheres and lights by integer intersection, shadows, inverse square (source 002)
  localparam int SPHERE_KIND = 2;
  localparam int SPHERE_WORDS = 50;
  function automatic logic [1:0] sphere_MODEL(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_MODEL = {words[1:0]};
  endfunction
  function automatic logic [1:0] sphere_FAULTS(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_FAULTS = {words[3:2]};
  endfunction
  function automatic logic [0:0] sphere_TINT(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_TINT = {words[4:4]};
  endfunction
  function automatic logic [1:0] sphere_N(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_N = {words[9:8]};
  endfunction
  function automatic logic [3:0] sphere_M(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_M = {words[15:12]};
  endfunction
  function automatic logic [7:0] sphere_CUTOFF(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_CUTOFF = {words[23:16]};
  endfunction
  function automatic logic [15:0] sphere_D(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_D = {words[63:48]};
  endfunction
  function automatic logic [15:0] sphere_K(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_K = {words[47:32]};
  endfunction
  function automatic logic signed [16:0] sphere_EX(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_EX = {words[80:64]};
  endfunction
  function automatic logic signed [16:0] sphere_EY(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_EY = {words[112:96]};
  endfunction
  function automatic logic signed [16:0] sphere_EZ(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_EZ = {words[144:128]};
  endfunction
  function automatic logic signed [16:0] sphere_F(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_F = {words[176:160]};
  endfunction
  function automatic logic signed [16:0] sphere_S1_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S1_X = {words[208:192]};
  endfunction
  function automatic logic signed [16:0] sphere_S1_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S1_Y = {words[240:224]};
  endfunction
  function automatic logic signed [16:0] sphere_S1_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S1_Z = {words[272:256]};
  endfunction
  function automatic logic [15:0] sphere_S1_R(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S1_R = {words[303:288]};
  endfunction
  function automatic logic signed [16:0] sphere_S2_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S2_X = {words[336:320]};
  endfunction
  function automatic logic signed [16:0] sphere_S2_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S2_Y = {words[368:352]};
  endfunction
  function automatic logic signed [16:0] sphere_S2_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S2_Z = {words[400:384]};
  endfunction
  function automatic logic [15:0] sphere_S2_R(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S2_R = {words[431:416]};
  endfunction
  function automatic logic signed [16:0] sphere_S3_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S3_X = {words[464:448]};
  endfunction
  function automatic logic signed [16:0] sphere_S3_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S3_Y = {words[496:480]};
  endfunction
  function automatic logic signed [16:0] sphere_S3_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S3_Z = {words[528:512]};
  endfunction
  function automatic logic [15:0] sphere_S3_R(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_S3_R = {words[559:544]};
  endfunction
  function automatic logic signed [16:0] sphere_L1_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L1_X = {words[592:576]};
  endfunction
  function automatic logic signed [16:0] sphere_L1_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L1_Y = {words[624:608]};
  endfunction
  function automatic logic signed [16:0] sphere_L1_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L1_Z = {words[656:640]};
  endfunction
  function automatic logic [30:0] sphere_L1_S(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L1_S = {words[702:672]};
  endfunction
  function automatic logic signed [16:0] sphere_L2_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L2_X = {words[720:704]};
  endfunction
  function automatic logic signed [16:0] sphere_L2_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L2_Y = {words[752:736]};
  endfunction
  function automatic logic signed [16:0] sphere_L2_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L2_Z = {words[784:768]};
  endfunction
  function automatic logic [30:0] sphere_L2_S(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L2_S = {words[830:800]};
  endfunction
  function automatic logic signed [16:0] sphere_L3_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L3_X = {words[848:832]};
  endfunction
  function automatic logic signed [16:0] sphere_L3_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L3_Y = {words[880:864]};
  endfunction
  function automatic logic signed [16:0] sphere_L3_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L3_Z = {words[912:896]};
  endfunction
  function automatic logic [30:0] sphere_L3_S(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L3_S = {words[958:928]};
  endfunction
  function automatic logic signed [16:0] sphere_L4_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L4_X = {words[976:960]};
  endfunction
  function automatic logic signed [16:0] sphere_L4_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L4_Y = {words[1008:992]};
  endfunction
  function automatic logic signed [16:0] sphere_L4_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L4_Z = {words[1040:1024]};
  endfunction
  function automatic logic [30:0] sphere_L4_S(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L4_S = {words[1086:1056]};
  endfunction
  function automatic logic signed [16:0] sphere_L5_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L5_X = {words[1104:1088]};
  endfunction
  function automatic logic signed [16:0] sphere_L5_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L5_Y = {words[1136:1120]};
  endfunction
  function automatic logic signed [16:0] sphere_L5_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L5_Z = {words[1168:1152]};
  endfunction
  function automatic logic [30:0] sphere_L5_S(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L5_S = {words[1214:1184]};
  endfunction
  function automatic logic signed [16:0] sphere_L6_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L6_X = {words[1232:1216]};
  endfunction
  function automatic logic signed [16:0] sphere_L6_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L6_Y = {words[1264:1248]};
  endfunction
  function automatic logic signed [16:0] sphere_L6_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L6_Z = {words[1296:1280]};
  endfunction
  function automatic logic [30:0] sphere_L6_S(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L6_S = {words[1342:1312]};
  endfunction
  function automatic logic signed [16:0] sphere_L7_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L7_X = {words[1360:1344]};
  endfunction
  function automatic logic signed [16:0] sphere_L7_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L7_Y = {words[1392:1376]};
  endfunction
  function automatic logic signed [16:0] sphere_L7_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L7_Z = {words[1424:1408]};
  endfunction
  function automatic logic [30:0] sphere_L7_S(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L7_S = {words[1470:1440]};
  endfunction
  function automatic logic signed [16:0] sphere_L8_X(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L8_X = {words[1488:1472]};
  endfunction
  function automatic logic signed [16:0] sphere_L8_Y(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L8_Y = {words[1520:1504]};
  endfunction
  function automatic logic signed [16:0] sphere_L8_Z(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L8_Z = {words[1552:1536]};
  endfunction
  function automatic logic [30:0] sphere_L8_S(input logic [32*SPHERE_WORDS-1:0] words);
    sphere_L8_S = {words[1598:1568]};
  endfunction

  // mandelbulb: deep-zoom Mandelbulb by 3D CORDIC and BKM (source 003)
  localparam int MANDELBULB_KIND = 3;
  localparam int MANDELBULB_WORDS = 27;
  function automatic logic signed [71:0] mandelbulb_X(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_X = {words[71:64], words[127:96], words[159:128]};
  endfunction
  function automatic logic signed [71:0] mandelbulb_Y(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_Y = {words[79:72], words[191:160], words[223:192]};
  endfunction
  function automatic logic signed [71:0] mandelbulb_Z(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_Z = {words[87:80], words[255:224], words[287:256]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_FX(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_FX = {words[314:288], words[351:320]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_FY(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_FY = {words[378:352], words[415:384]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_FZ(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_FZ = {words[442:416], words[479:448]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_RX(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_RX = {words[506:480], words[543:512]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_RY(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_RY = {words[570:544], words[607:576]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_RZ(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_RZ = {words[634:608], words[671:640]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_UX(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_UX = {words[698:672], words[735:704]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_UY(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_UY = {words[762:736], words[799:768]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_UZ(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_UZ = {words[826:800], words[863:832]};
  endfunction
  function automatic logic [6:0] mandelbulb_N(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_N = {words[14:8]};
  endfunction
  function automatic logic [6:0] mandelbulb_K(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_K = {words[22:16]};
  endfunction
  function automatic logic [4:0] mandelbulb_POWER(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_POWER = {words[28:24]};
  endfunction
  function automatic logic [6:0] mandelbulb_I(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_I = {words[38:32]};
  endfunction
  function automatic logic [4:0] mandelbulb_B(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_B = {words[44:40]};
  endfunction
  function automatic logic [7:0] mandelbulb_STEPS(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_STEPS = {words[55:48]};
  endfunction
  function automatic logic [0:0] mandelbulb_FORM(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_FORM = {words[0:0]};
  endfunction
  function automatic logic [0:0] mandelbulb_DERIVATIVE(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_DERIVATIVE = {words[1:1]};
  endfunction
  function automatic logic [5:0] mandelbulb_SCALE(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_SCALE = {words[61:56]};
  endfunction
  function automatic logic [0:0] mandelbulb_COLOUR(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_COLOUR = {words[2:2]};
  endfunction
  function automatic logic [0:0] mandelbulb_ASPECT(input logic [32*MANDELBULB_WORDS-1:0] words);
    mandelbulb_ASPECT = {words[3:3]};
  endfunction

  // whitted: spheres and planes with shadows, reflections and anti-aliasing in 12.12 (source 004)
  localparam int WHITTED_KIND = 4;
  localparam int WHITTED_WORDS = 88;
  function automatic logic [0:0] whitted_PROFILE(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_PROFILE = {words[31:31]};
  endfunction
  function automatic logic signed [23:0] whitted_EX(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_EX = {words[63:40]};
  endfunction
  function automatic logic signed [23:0] whitted_EY(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_EY = {words[95:72]};
  endfunction
  function automatic logic signed [23:0] whitted_EZ(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_EZ = {words[127:104]};
  endfunction
  function automatic logic signed [23:0] whitted_LX(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_LX = {words[159:136]};
  endfunction
  function automatic logic signed [23:0] whitted_LY(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_LY = {words[191:168]};
  endfunction
  function automatic logic signed [23:0] whitted_LZ(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_LZ = {words[223:200]};
  endfunction
  function automatic logic [10:0] whitted_LR(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_LR = {words[10:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S = {words[255:232]};
  endfunction
  function automatic logic [1:0] whitted_REFLECTIONS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_REFLECTIONS = {words[28:27]};
  endfunction
  function automatic logic [1:0] whitted_AA(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_AA = {words[26:25]};
  endfunction
  function automatic logic [0:0] whitted_PLANES(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_PLANES = {words[30:30]};
  endfunction
  function automatic logic [3:0] whitted_N(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_N = {words[24:21]};
  endfunction
  function automatic logic signed [23:0] whitted_S1_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S1_X = {words[287:264]};
  endfunction
  function automatic logic signed [23:0] whitted_S1_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S1_Y = {words[319:296]};
  endfunction
  function automatic logic signed [23:0] whitted_S1_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S1_Z = {words[351:328]};
  endfunction
  function automatic logic [10:0] whitted_S1_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S1_RADIUS = {words[374:364]};
  endfunction
  function automatic logic [4:0] whitted_S1_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S1_R = {words[260:256]};
  endfunction
  function automatic logic [4:0] whitted_S1_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S1_G = {words[292:288]};
  endfunction
  function automatic logic [4:0] whitted_S1_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S1_B = {words[324:320]};
  endfunction
  function automatic logic [11:0] whitted_S1_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S1_REFLECT = {words[363:352]};
  endfunction
  function automatic logic signed [23:0] whitted_S2_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S2_X = {words[415:392]};
  endfunction
  function automatic logic signed [23:0] whitted_S2_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S2_Y = {words[447:424]};
  endfunction
  function automatic logic signed [23:0] whitted_S2_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S2_Z = {words[479:456]};
  endfunction
  function automatic logic [10:0] whitted_S2_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S2_RADIUS = {words[502:492]};
  endfunction
  function automatic logic [4:0] whitted_S2_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S2_R = {words[388:384]};
  endfunction
  function automatic logic [4:0] whitted_S2_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S2_G = {words[420:416]};
  endfunction
  function automatic logic [4:0] whitted_S2_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S2_B = {words[452:448]};
  endfunction
  function automatic logic [11:0] whitted_S2_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S2_REFLECT = {words[491:480]};
  endfunction
  function automatic logic signed [23:0] whitted_S3_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S3_X = {words[543:520]};
  endfunction
  function automatic logic signed [23:0] whitted_S3_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S3_Y = {words[575:552]};
  endfunction
  function automatic logic signed [23:0] whitted_S3_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S3_Z = {words[607:584]};
  endfunction
  function automatic logic [10:0] whitted_S3_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S3_RADIUS = {words[630:620]};
  endfunction
  function automatic logic [4:0] whitted_S3_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S3_R = {words[516:512]};
  endfunction
  function automatic logic [4:0] whitted_S3_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S3_G = {words[548:544]};
  endfunction
  function automatic logic [4:0] whitted_S3_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S3_B = {words[580:576]};
  endfunction
  function automatic logic [11:0] whitted_S3_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S3_REFLECT = {words[619:608]};
  endfunction
  function automatic logic signed [23:0] whitted_S4_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S4_X = {words[671:648]};
  endfunction
  function automatic logic signed [23:0] whitted_S4_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S4_Y = {words[703:680]};
  endfunction
  function automatic logic signed [23:0] whitted_S4_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S4_Z = {words[735:712]};
  endfunction
  function automatic logic [10:0] whitted_S4_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S4_RADIUS = {words[758:748]};
  endfunction
  function automatic logic [4:0] whitted_S4_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S4_R = {words[644:640]};
  endfunction
  function automatic logic [4:0] whitted_S4_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S4_G = {words[676:672]};
  endfunction
  function automatic logic [4:0] whitted_S4_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S4_B = {words[708:704]};
  endfunction
  function automatic logic [11:0] whitted_S4_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S4_REFLECT = {words[747:736]};
  endfunction
  function automatic logic signed [23:0] whitted_S5_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S5_X = {words[799:776]};
  endfunction
  function automatic logic signed [23:0] whitted_S5_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S5_Y = {words[831:808]};
  endfunction
  function automatic logic signed [23:0] whitted_S5_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S5_Z = {words[863:840]};
  endfunction
  function automatic logic [10:0] whitted_S5_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S5_RADIUS = {words[886:876]};
  endfunction
  function automatic logic [4:0] whitted_S5_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S5_R = {words[772:768]};
  endfunction
  function automatic logic [4:0] whitted_S5_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S5_G = {words[804:800]};
  endfunction
  function automatic logic [4:0] whitted_S5_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S5_B = {words[836:832]};
  endfunction
  function automatic logic [11:0] whitted_S5_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S5_REFLECT = {words[875:864]};
  endfunction
  function automatic logic signed [23:0] whitted_S6_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S6_X = {words[927:904]};
  endfunction
  function automatic logic signed [23:0] whitted_S6_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S6_Y = {words[959:936]};
  endfunction
  function automatic logic signed [23:0] whitted_S6_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S6_Z = {words[991:968]};
  endfunction
  function automatic logic [10:0] whitted_S6_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S6_RADIUS = {words[1014:1004]};
  endfunction
  function automatic logic [4:0] whitted_S6_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S6_R = {words[900:896]};
  endfunction
  function automatic logic [4:0] whitted_S6_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S6_G = {words[932:928]};
  endfunction
  function automatic logic [4:0] whitted_S6_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S6_B = {words[964:960]};
  endfunction
  function automatic logic [11:0] whitted_S6_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S6_REFLECT = {words[1003:992]};
  endfunction
  function automatic logic signed [23:0] whitted_S7_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S7_X = {words[1055:1032]};
  endfunction
  function automatic logic signed [23:0] whitted_S7_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S7_Y = {words[1087:1064]};
  endfunction
  function automatic logic signed [23:0] whitted_S7_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S7_Z = {words[1119:1096]};
  endfunction
  function automatic logic [10:0] whitted_S7_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S7_RADIUS = {words[1142:1132]};
  endfunction
  function automatic logic [4:0] whitted_S7_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S7_R = {words[1028:1024]};
  endfunction
  function automatic logic [4:0] whitted_S7_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S7_G = {words[1060:1056]};
  endfunction
  function automatic logic [4:0] whitted_S7_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S7_B = {words[1092:1088]};
  endfunction
  function automatic logic [11:0] whitted_S7_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S7_REFLECT = {words[1131:1120]};
  endfunction
  function automatic logic signed [23:0] whitted_S8_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S8_X = {words[1183:1160]};
  endfunction
  function automatic logic signed [23:0] whitted_S8_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S8_Y = {words[1215:1192]};
  endfunction
  function automatic logic signed [23:0] whitted_S8_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S8_Z = {words[1247:1224]};
  endfunction
  function automatic logic [10:0] whitted_S8_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S8_RADIUS = {words[1270:1260]};
  endfunction
  function automatic logic [4:0] whitted_S8_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S8_R = {words[1156:1152]};
  endfunction
  function automatic logic [4:0] whitted_S8_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S8_G = {words[1188:1184]};
  endfunction
  function automatic logic [4:0] whitted_S8_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S8_B = {words[1220:1216]};
  endfunction
  function automatic logic [11:0] whitted_S8_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S8_REFLECT = {words[1259:1248]};
  endfunction
  function automatic logic signed [23:0] whitted_S9_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S9_X = {words[1311:1288]};
  endfunction
  function automatic logic signed [23:0] whitted_S9_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S9_Y = {words[1343:1320]};
  endfunction
  function automatic logic signed [23:0] whitted_S9_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S9_Z = {words[1375:1352]};
  endfunction
  function automatic logic [10:0] whitted_S9_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S9_RADIUS = {words[1398:1388]};
  endfunction
  function automatic logic [4:0] whitted_S9_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S9_R = {words[1284:1280]};
  endfunction
  function automatic logic [4:0] whitted_S9_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S9_G = {words[1316:1312]};
  endfunction
  function automatic logic [4:0] whitted_S9_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S9_B = {words[1348:1344]};
  endfunction
  function automatic logic [11:0] whitted_S9_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S9_REFLECT = {words[1387:1376]};
  endfunction
  function automatic logic signed [23:0] whitted_S10_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S10_X = {words[1439:1416]};
  endfunction
  function automatic logic signed [23:0] whitted_S10_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S10_Y = {words[1471:1448]};
  endfunction
  function automatic logic signed [23:0] whitted_S10_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S10_Z = {words[1503:1480]};
  endfunction
  function automatic logic [10:0] whitted_S10_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S10_RADIUS = {words[1526:1516]};
  endfunction
  function automatic logic [4:0] whitted_S10_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S10_R = {words[1412:1408]};
  endfunction
  function automatic logic [4:0] whitted_S10_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S10_G = {words[1444:1440]};
  endfunction
  function automatic logic [4:0] whitted_S10_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S10_B = {words[1476:1472]};
  endfunction
  function automatic logic [11:0] whitted_S10_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S10_REFLECT = {words[1515:1504]};
  endfunction
  function automatic logic signed [23:0] whitted_S11_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S11_X = {words[1567:1544]};
  endfunction
  function automatic logic signed [23:0] whitted_S11_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S11_Y = {words[1599:1576]};
  endfunction
  function automatic logic signed [23:0] whitted_S11_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S11_Z = {words[1631:1608]};
  endfunction
  function automatic logic [10:0] whitted_S11_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S11_RADIUS = {words[1654:1644]};
  endfunction
  function automatic logic [4:0] whitted_S11_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S11_R = {words[1540:1536]};
  endfunction
  function automatic logic [4:0] whitted_S11_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S11_G = {words[1572:1568]};
  endfunction
  function automatic logic [4:0] whitted_S11_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S11_B = {words[1604:1600]};
  endfunction
  function automatic logic [11:0] whitted_S11_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S11_REFLECT = {words[1643:1632]};
  endfunction
  function automatic logic signed [23:0] whitted_S12_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S12_X = {words[1695:1672]};
  endfunction
  function automatic logic signed [23:0] whitted_S12_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S12_Y = {words[1727:1704]};
  endfunction
  function automatic logic signed [23:0] whitted_S12_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S12_Z = {words[1759:1736]};
  endfunction
  function automatic logic [10:0] whitted_S12_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S12_RADIUS = {words[1782:1772]};
  endfunction
  function automatic logic [4:0] whitted_S12_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S12_R = {words[1668:1664]};
  endfunction
  function automatic logic [4:0] whitted_S12_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S12_G = {words[1700:1696]};
  endfunction
  function automatic logic [4:0] whitted_S12_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S12_B = {words[1732:1728]};
  endfunction
  function automatic logic [11:0] whitted_S12_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S12_REFLECT = {words[1771:1760]};
  endfunction
  function automatic logic signed [23:0] whitted_S13_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S13_X = {words[1823:1800]};
  endfunction
  function automatic logic signed [23:0] whitted_S13_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S13_Y = {words[1855:1832]};
  endfunction
  function automatic logic signed [23:0] whitted_S13_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S13_Z = {words[1887:1864]};
  endfunction
  function automatic logic [10:0] whitted_S13_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S13_RADIUS = {words[1910:1900]};
  endfunction
  function automatic logic [4:0] whitted_S13_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S13_R = {words[1796:1792]};
  endfunction
  function automatic logic [4:0] whitted_S13_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S13_G = {words[1828:1824]};
  endfunction
  function automatic logic [4:0] whitted_S13_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S13_B = {words[1860:1856]};
  endfunction
  function automatic logic [11:0] whitted_S13_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S13_REFLECT = {words[1899:1888]};
  endfunction
  function automatic logic signed [23:0] whitted_S14_X(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S14_X = {words[1951:1928]};
  endfunction
  function automatic logic signed [23:0] whitted_S14_Y(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S14_Y = {words[1983:1960]};
  endfunction
  function automatic logic signed [23:0] whitted_S14_Z(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S14_Z = {words[2015:1992]};
  endfunction
  function automatic logic [10:0] whitted_S14_RADIUS(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S14_RADIUS = {words[2038:2028]};
  endfunction
  function automatic logic [4:0] whitted_S14_R(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S14_R = {words[1924:1920]};
  endfunction
  function automatic logic [4:0] whitted_S14_G(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S14_G = {words[1956:1952]};
  endfunction
  function automatic logic [4:0] whitted_S14_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S14_B = {words[1988:1984]};
  endfunction
  function automatic logic [11:0] whitted_S14_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_S14_REFLECT = {words[2027:2016]};
  endfunction
  function automatic logic signed [23:0] whitted_P1_A(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_A = {words[2079:2056]};
  endfunction
  function automatic logic signed [23:0] whitted_P1_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_B = {words[2111:2088]};
  endfunction
  function automatic logic signed [23:0] whitted_P1_C(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_C = {words[2143:2120]};
  endfunction
  function automatic logic signed [23:0] whitted_P1_D(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_D = {words[2175:2152]};
  endfunction
  function automatic logic [4:0] whitted_P1_RED(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_RED = {words[2052:2048]};
  endfunction
  function automatic logic [4:0] whitted_P1_GREEN(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_GREEN = {words[2084:2080]};
  endfunction
  function automatic logic [4:0] whitted_P1_BLUE(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_BLUE = {words[2116:2112]};
  endfunction
  function automatic logic [3:0] whitted_P1_CHECKER(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_CHECKER = {words[2147:2144]};
  endfunction
  function automatic logic [0:0] whitted_P1_BOUNDED(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_BOUNDED = {words[2148:2148]};
  endfunction
  function automatic logic [11:0] whitted_P1_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_REFLECT = {words[2187:2176]};
  endfunction
  function automatic logic [11:0] whitted_P1_XL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_XL = {words[2199:2188]};
  endfunction
  function automatic logic [11:0] whitted_P1_YL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_YL = {words[2235:2224]};
  endfunction
  function automatic logic [11:0] whitted_P1_ZL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P1_ZL = {words[2219:2208]};
  endfunction
  function automatic logic signed [23:0] whitted_P2_A(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_A = {words[2271:2248]};
  endfunction
  function automatic logic signed [23:0] whitted_P2_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_B = {words[2303:2280]};
  endfunction
  function automatic logic signed [23:0] whitted_P2_C(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_C = {words[2335:2312]};
  endfunction
  function automatic logic signed [23:0] whitted_P2_D(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_D = {words[2367:2344]};
  endfunction
  function automatic logic [4:0] whitted_P2_RED(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_RED = {words[2244:2240]};
  endfunction
  function automatic logic [4:0] whitted_P2_GREEN(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_GREEN = {words[2276:2272]};
  endfunction
  function automatic logic [4:0] whitted_P2_BLUE(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_BLUE = {words[2308:2304]};
  endfunction
  function automatic logic [3:0] whitted_P2_CHECKER(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_CHECKER = {words[2339:2336]};
  endfunction
  function automatic logic [0:0] whitted_P2_BOUNDED(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_BOUNDED = {words[2340:2340]};
  endfunction
  function automatic logic [11:0] whitted_P2_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_REFLECT = {words[2379:2368]};
  endfunction
  function automatic logic [11:0] whitted_P2_XL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_XL = {words[2391:2380]};
  endfunction
  function automatic logic [11:0] whitted_P2_YL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_YL = {words[2427:2416]};
  endfunction
  function automatic logic [11:0] whitted_P2_ZL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P2_ZL = {words[2411:2400]};
  endfunction
  function automatic logic signed [23:0] whitted_P3_A(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_A = {words[2463:2440]};
  endfunction
  function automatic logic signed [23:0] whitted_P3_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_B = {words[2495:2472]};
  endfunction
  function automatic logic signed [23:0] whitted_P3_C(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_C = {words[2527:2504]};
  endfunction
  function automatic logic signed [23:0] whitted_P3_D(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_D = {words[2559:2536]};
  endfunction
  function automatic logic [4:0] whitted_P3_RED(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_RED = {words[2436:2432]};
  endfunction
  function automatic logic [4:0] whitted_P3_GREEN(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_GREEN = {words[2468:2464]};
  endfunction
  function automatic logic [4:0] whitted_P3_BLUE(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_BLUE = {words[2500:2496]};
  endfunction
  function automatic logic [3:0] whitted_P3_CHECKER(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_CHECKER = {words[2531:2528]};
  endfunction
  function automatic logic [0:0] whitted_P3_BOUNDED(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_BOUNDED = {words[2532:2532]};
  endfunction
  function automatic logic [11:0] whitted_P3_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_REFLECT = {words[2571:2560]};
  endfunction
  function automatic logic [11:0] whitted_P3_XL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_XL = {words[2583:2572]};
  endfunction
  function automatic logic [11:0] whitted_P3_YL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_YL = {words[2619:2608]};
  endfunction
  function automatic logic [11:0] whitted_P3_ZL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P3_ZL = {words[2603:2592]};
  endfunction
  function automatic logic signed [23:0] whitted_P4_A(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_A = {words[2655:2632]};
  endfunction
  function automatic logic signed [23:0] whitted_P4_B(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_B = {words[2687:2664]};
  endfunction
  function automatic logic signed [23:0] whitted_P4_C(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_C = {words[2719:2696]};
  endfunction
  function automatic logic signed [23:0] whitted_P4_D(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_D = {words[2751:2728]};
  endfunction
  function automatic logic [4:0] whitted_P4_RED(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_RED = {words[2628:2624]};
  endfunction
  function automatic logic [4:0] whitted_P4_GREEN(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_GREEN = {words[2660:2656]};
  endfunction
  function automatic logic [4:0] whitted_P4_BLUE(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_BLUE = {words[2692:2688]};
  endfunction
  function automatic logic [3:0] whitted_P4_CHECKER(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_CHECKER = {words[2723:2720]};
  endfunction
  function automatic logic [0:0] whitted_P4_BOUNDED(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_BOUNDED = {words[2724:2724]};
  endfunction
  function automatic logic [11:0] whitted_P4_REFLECT(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_REFLECT = {words[2763:2752]};
  endfunction
  function automatic logic [11:0] whitted_P4_XL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_XL = {words[2775:2764]};
  endfunction
  function automatic logic [11:0] whitted_P4_YL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_YL = {words[2811:2800]};
  endfunction
  function automatic logic [11:0] whitted_P4_ZL(input logic [32*WHITTED_WORDS-1:0] words);
    whitted_P4_ZL = {words[2795:2784]};
  endfunction

endpackage
